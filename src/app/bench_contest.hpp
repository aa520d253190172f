#pragma once
#include <memory>
#include <optional>

#include "app/bench_result.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"
#include "sim/simulation.hpp"
#include "sim_gl/gl_layout.hpp"
#include "window/context.hpp"

namespace sunder::app {

struct BenchLimits {
    int repeats = 5;
    double secondsPerCell = 5;   ///< of a table: one entrant, one scene, all repeats
    double secondsPerRun = 0.4;  ///< wanted; a run is whole frames where that many fit
    int framesPerRun = 20;       ///< at most; less than 30, or a solver lets what is at rest sleep
    int drawnFramesPerRun = 20;  ///< at most
};

double median(std::vector<double> values);

/// The fewest steps worth timing: a whole number of fracture intervals, 8 or about that.
int fewestSteps(const core::WorldDescription&);

/// Several solvers on one world. Their runs are interleaved, so that whatever else the machine does
/// hits all alike; each run starts from the same state and is timed once the first event is over.
class Contest {
  public:
    /// `context`: the current one, or null: then only CPU solvers may take part, and nothing is
    /// drawn. A solver that the device has no room for is skipped, with the reason in its
    /// result.
    Contest(scene::Scene, const std::vector<Entrant>&, const BenchLimits&,
            const window::Context* context);
    Contest(const Contest&) = delete;
    Contest& operator=(const Contest&) = delete;

    const core::World& world() const { return layout_->world(); }
    /// How the world begins (app/start.hpp).
    const core::State& start();

    /// One result per entrant, in their order. `part` goes into the results.
    std::vector<BenchResult> measure(const std::string& part, const core::State& start);
    std::vector<BenchResult> measure(const std::string& part) { return measure(part, start()); }
    /// Adds msPerFrameDrawn to what measure() returned: 1280 x 720, read back like `sunder run`
    /// does.
    void measureDrawn(std::vector<BenchResult>& results);
    /// Adds msPerFrameBreaking and msPerFrameWorst to what measure() returned.
    void measureBreaking(std::vector<BenchResult>& results);
    /// Times of the passes of the GPU solvers (gpu::PassTimer).
    std::vector<PassResult> measurePasses();
    /// The state after about this many frames, or fewer where that would take too long; by whoever
    /// is fastest. Needs a measure() before.
    core::State stateAfter(int frames);

  private:
    struct Lane {
        Entrant entrant;
        std::unique_ptr<sim::Simulation> simulation;
        std::optional<double> bytes;
        std::string skipped;
        double stepSeconds = 0;  ///< estimate
    };
    void makeSimulation(Lane&);
    /// Estimates stepSeconds. Sets `skipped` where the fewest steps would take too long.
    void probe(Lane&, const core::State& start);
    int stepsPerRun(const Lane&) const;
    void prepare(Lane&, const core::State& start) const;
    /// Lets a solver that shares bodies out find its shares.
    void settle(Lane&, const core::State& start) const;
    double timedRun(Lane&, int steps) const;
    int leadSteps(const core::State& start) const;
    /// Frames from the start to the last of framesPerRun that breaks a bond.
    int breakingFrames(Lane&, const core::State& start) const;

    scene::Scene scene_;
    std::shared_ptr<sim_gl::GlLayout> layout_;
    std::optional<core::State> start_;  ///< once asked for
    BenchLimits limits_;
    bool software_;               ///< the driver computes on the CPU
    std::size_t worldBytes_ = 0;  ///< on the GPU
    std::vector<Lane> lanes_;
};

}  // namespace sunder::app
