#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "sim/simulation.hpp"
#include "sim_gl/drawn_state.hpp"

namespace sunder::view {

/// A hit at a spot: everything within `radius` of it gains velocity.
struct Push {
    core::Vec3 place{0, 0, 0};     ///< m
    core::Vec3 velocity{0, 0, 0};  ///< m/s, at the spot; less towards the rim, where it is 0
    double radius = 0.3;           ///< m
    int object = -1;               ///< this object is pushed as a whole instead
};

/// A scene and its simulation. Needs a current GL context.
class PlayedScene {
  public:
    /// Throws InputError for a scene that cannot be laid out. `hits`: whether the scene's own
    /// events push bodies; throws there are anyway. `state`: of a world with the same cells, to go
    /// on from.
    PlayedScene(scene::Scene, const std::string& solver, bool hits,
                const core::State* state = nullptr);

    const scene::Scene& scene() const { return scene_; }
    const core::World& world() const { return simulation_.world(); }
    const gpu::WorldBuffers& buffers() const { return *simulation_.layout().buffers(); }
    const sim::SolverInfo& solverInfo() const { return simulation_.solverInfo(); }
    const core::Solver& solver() const { return simulation_.solver(); }
    double time() const { return simulation_.time(); }     ///< s
    int stepsPerFrame() const { return scene_.substeps; }  ///< substeps in 1/60 s

    /// Goes on with another one from the same state. Throws InputError, and then nothing changed.
    void setSolver(const std::string& name);
    void restart();
    /// Whether nothing has happened since the start.
    bool atStart() const { return atStart_; }
    /// Another number whenever the state may have changed.
    std::int64_t changes() const { return changes_; }
    /// What is to be said of how the world begins; empty where there is nothing.
    std::string startWarning() { return cpu::restlessWarning(simulation_.start()); }
    /// Pushes, then advances, then waits until it is done. Bodies that nothing pushes sleep on.
    void advance(const std::vector<Push>&, int steps);

    /// The last state, fetched at most once per advance().
    const core::State& state() { return simulation_.state(); }
    gpu::StateView view() { return drawn_.view(); }
    /// Where passes are timed from now on; null: nowhere. Only GPU solvers have passes.
    void timePasses(gpu::PassTimer*);
    /// Cells and bonds of which something was heard since the last call.
    std::vector<core::Incident> takeIncidents() { return simulation_.takeIncidents(); }

  private:
    void push(const Push&);

    scene::Scene scene_;
    sim::Simulation simulation_;
    sim_gl::DrawnState drawn_;
    bool atStart_;
    std::int64_t changes_ = 0;
};

}  // namespace sunder::view
