#pragma once
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/incident.hpp"
#include "cpu/settle.hpp"
#include "scene/scene.hpp"
#include "sim/solver_factory.hpp"

namespace sunder::view {

/// A blow at a spot: everything within `radius` of it gains velocity.
struct Push {
    core::Vec3 place{0, 0, 0};     ///< m
    core::Vec3 velocity{0, 0, 0};  ///< m/s, at the spot; less towards the rim, where it is 0
    double radius = 0.3;           ///< m
    int object = -1;               ///< this object is pushed as a whole instead
};

/// Adds a push's velocity to a state, and the bodies that it moved to others.
void apply(const Push&, const core::World&, core::State&, std::set<int>& bodies);

/// A world and the solver that advances it. Needs a current GL context.
class Simulation {
  public:
    /// Throws InputError for a scene that cannot be laid out. `hits`: whether the scene's own
    /// events push bodies; throws there are anyway. `state`: of a world with the same cells, to go
    /// on from.
    Simulation(scene::Scene, const std::string& solver, bool hits,
               const core::State* state = nullptr);

    const scene::Scene& scene() const { return scene_; }
    const core::World& world() const { return world_; }
    const gpu::WorldBuffers& buffers() const { return buffers_; }
    const sim::SolverInfo& solverInfo() const { return *info_; }
    const core::Solver& solver() const { return *solver_; }
    double time() const { return static_cast<double>(stepsDone_) * world_.step(); }  ///< s
    int stepsPerFrame() const { return scene_.substeps; }  ///< substeps in 1/60 s

    /// Goes on with another one from the same state. Throws InputError, and then nothing changed.
    void setSolver(const std::string& name);
    void restart();
    /// Whether nothing has happened since the start.
    bool atStart() const { return atStart_; }
    /// What is to be said of how the world begins; empty where there is nothing.
    std::string startWarning() { return cpu::restlessWarning(start()); }
    /// Pushes, then advances, then waits until it is done. Bodies that nothing pushes sleep on.
    /// Each push costs a GPU solver the way of its state to the CPU and back: they are for a hand
    /// on a mouse, not for a game's hundred explosions.
    void advance(const std::vector<Push>&, int steps);

    /// The last state, fetched at most once per advance().
    const core::State& state();
    gpu::StateView view() { return view_->view(); }
    /// Where passes are timed from now on; null: nowhere. Only GPU solvers have passes.
    void timePasses(gpu::PassTimer*);
    /// Cells and bonds of which something was heard since the last call.
    std::vector<core::Incident> takeIncidents() { return incidents_.take(); }

  private:
    void adopt(std::unique_ptr<core::Solver>, const sim::SolverInfo&);
    const cpu::Start& start();

    scene::Scene scene_;
    core::World world_;
    gpu::WorldBuffers buffers_;
    core::IncidentRing incidents_;
    const sim::SolverInfo* info_ = nullptr;
    std::unique_ptr<core::Solver> solver_;
    std::unique_ptr<sim::SolverView> view_;
    std::int64_t stepsDone_ = 0;
    std::optional<core::State> state_;
    std::optional<cpu::Start> start_;  ///< once asked for
    bool atStart_ = true;
};

}  // namespace sunder::view
