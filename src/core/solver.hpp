#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "core/world.hpp"

namespace sunder::core {

class Archive;
class IncidentRing;

/// Is told what the passes of a step wrote, as far as Solver::state() does not show it: forces,
/// stresses, links. Slow; it tells where two runs part.
class PassObserver {
  public:
    virtual ~PassObserver() = default;
    /// Comes several times for a pass that wrote to several places, always in the same order.
    virtual void wrote(std::string_view pass, std::span<const float> values) = 0;
};

/// A copy of a solver's state on its way from a GPU.
class StateCopy {
  public:
    virtual ~StateCopy() = default;
    /// From now on the state as it is now. Waits for nothing.
    virtual void start() = 0;
    /// The state as it was when start() was called last. Waits only where the GPU is not that far.
    virtual State take() = 0;
};

/// Advances a world in time. Every solver means the same physics (shared contract:
/// docs/solvers.md#what-they-share).
class Solver {
  public:
    virtual ~Solver() = default;
    virtual std::string_view name() const = 0;
    /// Advances by this many substeps. May return before a GPU is done.
    virtual void advance(int steps) = 0;
    /// Returns once everything that advance() started is done.
    virtual void finish() {}
    virtual State state() const = 0;
    /// Null where state() waits for no GPU. It must not outlive the solver.
    virtual std::unique_ptr<StateCopy> makeStateCopy() const { return nullptr; }
    /// `state` must come from the same world. Everything wakes.
    virtual void setState(const State& state) = 0;
    /// All that it knows (core/saved_state.hpp), once finish() was called.
    virtual void archive(Archive& archive) = 0;
    /// From the next step on this event acts, too, as if the world's description had had it
    /// (World::makeEvent()): the same bits follow. It must not begin before the step that the
    /// solver is at. What sleeps in its reach wakes when it begins. Nothing is read back, and
    /// nothing waits.
    virtual void push(const Event& event) = 0;
    /// Puts an object somewhere at once, as a throw does at its time: the same bits follow. It
    /// wakes, and what it may hit.
    virtual void putObject(int object, const ObjectState& state) = 0;
    /// Puts a body there, or takes it away, at once. One that is put there is whole, at rest where
    /// it was described, and awake, and wakes what sleeps around it; what lies in its way by then
    /// is pushed out. One that is taken away touches nothing, does not move, and wakes what slept
    /// on it; pushes act on it only while it is there. Contacts are searched for at once. At steps
    /// divisible by World::contactInterval(), where that is due anyway and where sim::Simulation
    /// asks for it, what touches no such body has the same bits with and without it. Nothing
    /// changes where it is as it should be already. Of the solvers on a GPU, `scatter` waits for
    /// it.
    virtual void setPresent(int body, bool present) = 0;
    /// Whether a body is there.
    virtual bool present(int body) const = 0;
    /// Lets go of a body's anchors at once, until it is put there anew; it wakes, with what sleeps
    /// with it. Nothing is read back, and nothing waits. Nothing changes where it has none, or is
    /// not there.
    virtual void releaseAnchors(int body) = 0;
    /// Whether they have let go.
    virtual bool released(int body) const = 0;
    /// How many bodies a GPU has at the moment, where a solver shares them out; else nothing.
    virtual std::optional<int> bodiesOnGpu() const { return std::nullopt; }
    /// Whether a solver that measures where bodies are best off knows it, for the load as it is.
    virtual bool settled() const { return true; }
    /// Whether a body or an object is at rest and costs nothing (core/sleep.hpp); solvers may never
    /// let one.
    virtual bool asleep([[maybe_unused]] int body) const { return false; }
    virtual bool objectAsleep([[maybe_unused]] int object) const { return false; }
    /// Contacts that found no room in one search, at most as far as is known; they were left out.
    /// Zero for a solver that has room for all.
    virtual std::int64_t droppedContacts() const { return 0; }
    /// How many times as fast as a search for contacts can follow cells of each body have met
    /// others, as far as is known: contacts between them may have been missed where that is more
    /// than 1. Empty for a solver that follows at any speed.
    virtual std::vector<double> contactHaste() const { return {}; }
    /// Where incidents go from now on. Null, the default: none are looked for, at no cost. The
    /// state does not depend on it. Solvers on a GPU hand them over two looks late, all in
    /// finish(). The ring must outlive its use here.
    virtual void setIncidents(IncidentRing* ring) = 0;
    /// Who is told of passes from now on. Null, the default: nobody, at no cost. The state does not
    /// depend on it. False: this solver has nothing to tell.
    virtual bool setPassObserver([[maybe_unused]] PassObserver* observer) { return false; }
};

}  // namespace sunder::core
