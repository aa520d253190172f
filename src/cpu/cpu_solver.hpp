#pragma once
#include <memory>
#include <vector>

#include "core/body_book.hpp"
#include "core/body_host.hpp"
#include "core/solver.hpp"
#include "cpu/threads.hpp"

namespace sunder::cpu {

class BodyRun;

/// What a game would ship: several cells at once on every core, single precision. Bodies are shared
/// out to the cores whole where there are enough of them; a large one is split into stretches of
/// cells. The result does not depend on the number of cores or the width of their vectors.
/// Bodies at rest sleep (core/sleep.hpp). Bodies that it does not hold are in contact with nothing.
class CpuSolver : public core::Solver, public core::BodyHost {
  public:
    /// `world` must outlive the solver.
    explicit CpuSolver(const core::World& world, const Threads& threads = {});
    ~CpuSolver() override;

    std::string_view name() const override { return "cpu"; }
    void advance(int steps) override;
    core::State state() const override;
    void setState(const core::State& state) override;
    void archive(core::Archive& archive) override;
    void push(const core::Event& event) override;
    void putObject(int object, const core::ObjectState& state) override;
    void setPresent(int body, bool present) override;
    bool present(int body) const override { return book_.present(body); }
    void releaseAnchors(int body) override;
    bool released(int body) const override { return book_.released(body); }
    bool asleep(int body) const override;
    bool objectAsleep(int object) const override;
    void setIncidents(core::IncidentRing* ring) override;
    bool setPassObserver(core::PassObserver* observer) override;

    void adopt(const std::vector<int>& bodies, const core::State& state) override;
    void release(const std::vector<int>& bodies, core::State& state) override;
    bool holds(int body) const override { return book_.holds(body); }
    /// Puts a body that it holds into its part of `state`.
    void store(int body, core::State& state) const;
    void storeObjects(core::State& state) const;

    /// J, of bodies that it holds and of objects.
    double kineticEnergy() const;
    /// Of bodies and objects. Wakes every body.
    void scaleVelocities(double factor);

    int threads() const;
    /// Bytes held per tetrahedron, all bodies together.
    double bytesPerTetrahedron() const;

  private:
    struct Runner;
    void shareOut();
    /// contact: with what the last search found.
    void advanceTo(std::int64_t end, bool contact);
    /// Advances bodies that touch nothing, each by itself.
    void advanceAlone(int steps);
    /// Advances bodies in contact, step by step: each island by one thread, or a large one by all.
    void advanceTouching(int steps);
    /// Advances all bodies, step by step, and tells the observer what each pass wrote.
    void advanceObserved(int steps, bool contact);
    void advanceIsland(int steps, const std::vector<int>& bodies);
    void advanceLargeIsland(int steps, const std::vector<int>& bodies);
    void searchContacts();
    /// Lets islands fall asleep all of which have been calm for long enough.
    void rest();
    /// Wakes a body or an object and what sleeps with it (core/rest_islands.hpp).
    void wake(int member) { woke(book_.wake(member)); }
    void woke(const core::BodyBook::Members& members);
    /// As they are; empty where the world has no objects.
    const std::vector<core::ObjectState>& objectStates() const;
    /// What an event pushes before step number `until`; whether anything did wake.
    bool wakePushed(std::int64_t until);
    /// Likewise, of objects; none of them falls asleep now.
    bool wakePushedObjects(std::int64_t until);
    void startThrows();
    /// active: which bodies are, by what is archived.
    void archiveTouching(core::Archive& archive, const std::vector<bool>& active);
    /// Wakes a body that comes or goes, and what sleeps on it.
    void wakeAround(int body);
    void setObjects(const core::State& state);
    void findIslands();
    void lookForIncidents();
    /// Whether objects advance with this island: the first one.
    bool hasObjects(const std::vector<int>& island) const;

    int bodyCount() const { return static_cast<int>(bodies_.size()); }
    int objectCount() const { return static_cast<int>(world_.objects().size()); }

    const core::World& world_;
    core::EventSchedule events_;
    std::int64_t step_ = 0;
    std::vector<std::unique_ptr<BodyRun>> bodies_;
    /// Without contact bodies fall asleep each by itself, and only they know.
    core::BodyBook book_;
    std::unique_ptr<Runner> runner_;
};

}  // namespace sunder::cpu
