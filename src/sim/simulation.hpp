#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/incident.hpp"
#include "core/saved_state.hpp"
#include "cpu/settle.hpp"
#include "sim/late_states.hpp"
#include "sim/layout.hpp"
#include "sim/solvers.hpp"

namespace sunder::sim {

/// A world on its way through time: what `sunder run`, `bench` and `view` simulate with. Begins at
/// rest under its own weight (cpu/settle.hpp) once restart() was called, and as described until
/// then.
class Simulation {
  public:
    /// threads: of threaded solvers, and to find how the world begins. `incidents`: how many are
    /// kept until they are taken; 0: none are looked for. Throws InputError where the device has
    /// no room for the solver.
    Simulation(std::shared_ptr<const Layout>, const SolverInfo&, const cpu::Threads& threads = {},
               std::size_t incidents = 0);

    const core::World& world() const { return layout_->world(); }
    const Layout& layout() const { return *layout_; }
    const core::Solver& solver() const { return *made_.solver; }
    const SolverInfo& solverInfo() const { return *info_; }
    /// Goes on with another solver from the same state. Throws InputError, and then nothing has
    /// changed.
    void setSolver(const SolverInfo&);

    /// How the world begins, found when it is first asked for. That may take seconds.
    const cpu::Start& start(const cpu::SettleProgress& progress = {});
    /// Goes on in a larger world, whose materials, bodies and objects begin with those of this one:
    /// what is new begins as described. Waits for a GPU; everything wakes, and what may touch is
    /// searched for anew. Throws InputError where the device has no room, and then nothing has
    /// changed.
    void extend(std::shared_ptr<const Layout>);
    /// Back to start().
    void restart();
    /// Goes on from a state of this world, or of one with the same cells. What setPresent() still
    /// had to do is dropped.
    void setState(const core::State&);
    /// All that the solver knows (core/saved_state.hpp), for rollback and checkpoints. Changes
    /// nothing that is to come. Waits for a GPU, as finish() does.
    std::vector<std::byte> saveState();
    /// Goes on from there to the bit, and so does another simulation of the same world with the
    /// same solver, whatever number of threads it has; only `auto` goes on as from setState().
    /// start() and incidents not yet taken are what they were. Throws InputError for bytes that
    /// saveState() did not give, or those of another world or solver; then nothing has changed.
    void restoreState(std::span<const std::byte> bytes);
    /// The last state, fetched at most once until it changes. Waits for a GPU.
    const core::State& state();
    /// A state to look at in every frame without waiting: of a GPU that of LateStates::kLateness
    /// calls of advance() ago, or the last one after finish(); of a CPU the last one. Which one it
    /// is depends on the calls alone. It waits where it was not called for LateStates::kPatience
    /// calls of advance(), or a body came or went since, or the state was set.
    const core::State& lateState();

    std::int64_t step() const { return step_; }
    double time() const { return static_cast<double>(step_) * world().step(); }  ///< s

    /// Its `time` counts from now: at 0 it begins with the next step. Nothing is read back. Throws
    /// InputError where it makes no sense or could push nothing.
    void push(const core::EventDescription&);
    /// Throws an object at once, whatever `time` the throw has. Throws InputError for what
    /// check() would refuse of it.
    void throwObject(const core::ThrowDescription&);
    /// Puts an object somewhere at once, or takes it away (`present`). Precondition: there is such
    /// an object, and all numbers of the state are finite, its orientation of length 1; who has
    /// them from elsewhere checks them, as World::setKinematic() does.
    void putObject(int object, const core::ObjectState&);
    /// Puts a body there or takes it away (core::Solver::setPresent()): at once where the step is
    /// divisible by World::contactInterval(), else at the next one that is, on the way of
    /// advance(). So what touches no such body keeps its bits. A push that names a body on its way
    /// begins with it. Throws InputError for an index that is none.
    void setPresent(int body, bool present);
    /// Lets go of a body's anchors at once, or as it comes where it is on its way. Throws
    /// InputError for an index that is none.
    void releaseAnchors(int body);
    /// Whether they have let go, or will as it comes.
    bool released(int body) const;
    /// Whether it is there, or will be by what setPresent() was told last.
    bool present(int body) const;

    /// Grows whenever anything that is seen may have changed.
    std::int64_t version() const { return version_; }
    /// version() when a body's cells may have changed last: what sleeps does not, nor what is not
    /// there.
    std::int64_t version(int body) const { return versions_[body]; }
    /// Whether time changes nothing until something is put in: all bodies that are there and all
    /// objects that can move are known to sleep. Waits for nothing.
    bool atRest() const;
    /// Whole substeps. May return before a GPU is done.
    void advance(int steps);
    /// Waits for it.
    void finish();
    /// What was found since the last time, oldest first. GPU solvers find things two looks late,
    /// all of them in finish().
    std::vector<core::Incident> takeIncidents() { return incidents_.take(); }
    /// What was overwritten before it was taken, or found no room on a GPU.
    std::int64_t droppedIncidents() const { return incidents_.dropped(); }
    std::size_t incidentRoom() const { return incidents_.capacity(); }

    /// The solver, if its state is on a GPU; else null.
    gpu::GpuSolver* gpuSolver() { return made_.onGpu; }

  private:
    void adopt(MadeSolver, const SolverInfo&);
    /// What the solver is told of this body last; null: nothing.
    const core::PresenceChange* lastChange(int body) const;
    void checkBody(int body) const;  ///< throws InputError
    bool rests(int body) const;      ///< or is not there
    void touch(int body) { versions_[body] = ++version_; }
    void touchAll();
    bool comes(int body) const;  ///< at nextSearch()
    /// From this step on the first that is divisible by World::contactInterval().
    std::int64_t nextSearch() const;
    void advanceSolver(int steps);

    std::shared_ptr<const Layout> layout_;
    cpu::Threads threads_;
    bool findsIncidents_;
    core::IncidentRing incidents_;
    const SolverInfo* info_ = nullptr;
    MadeSolver made_;
    std::int64_t step_ = 0;
    std::optional<core::State> state_;
    LateStates late_;
    std::int64_t version_ = 0;
    std::vector<std::int64_t> versions_;  ///< per body
    std::optional<cpu::Start> start_;
    std::vector<core::PresenceChange> changes_;  ///< at nextSearch()
};

}  // namespace sunder::sim
