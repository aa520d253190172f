#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sim/solvers.hpp"

namespace sunder::app {

/// One line of competitors: a solver, and with how many threads.
struct Entrant {
    const sim::SolverInfo* solver = nullptr;
    int threads = 1;  ///< 1 unless the solver is threaded
    /// "gather", "cpu, 2 threads"
    std::string label() const;
};

/// What one entrant needed for one scene. Times are medians of `runs`.
struct BenchResult {
    std::string part;  ///< which table it belongs to: frames, one-step, scaling, intact, broken, …
    std::string scene;
    std::string label;  ///< Entrant::label()
    std::string solver;
    int threads = 1;
    int bodies = 0, tetrahedra = 0, stepsPerFrame = 0;
    bool stiffnessLimited = false;  ///< the step does not carry a material's Young's modulus
    double msPerStep = 0;
    int stepsPerRun = 0, runs = 0;
    std::optional<double> msPerFrameDrawn;  ///< a frame's steps and its picture
    /// Of the frames from the first one to the last that breaks a bond: their median, and the
    /// slowest; each frame's time is the median of the runs.
    std::optional<double> msPerFrameBreaking, msPerFrameWorst;
    std::optional<double> bytesPerTetrahedron;  ///< of the solver, beyond the world it reads
    double bondsBroken = 0;                     ///< share of all, at the start of a run
    std::string skipped;                        ///< why it was not measured; empty: it was

    double msPerFrame() const { return msPerStep * stepsPerFrame; }  ///< 1/60 s of simulated time
    double megaTetrahedraPerSecond() const { return tetrahedra / msPerStep / 1000; }
    double nanosecondsPerTetrahedron() const { return msPerStep * 1e6 / tetrahedra; }
};

/// What one pass of a GPU solver needed.
struct PassResult {
    std::string scene, solver, pass;
    int tetrahedra = 0;
    double milliseconds = 0;  ///< median of its runs
    double runsPerFrame = 0;
};

/// What pictures of one state of a scene cost: medians, in 1280 x 720, with shadows and four
/// samples, not read back.
struct DrawingResult {
    std::string scene, state;  ///< state: "intact", "broken"
    int bodies = 0, cells = 0;
    std::size_t vertices = 0, triangles = 0;  ///< of the display mesh
    double msDisplay = 0, msSimulation = 0;   ///< per picture of either mesh
    double msSurface = 0;                     ///< of deforming that one for a host that draws it
    double msGather = 0;                      ///< that `gather` simulates 1/60 s from there
};

/// Frames through the public library and by the solver alone, in turn.
struct LibraryResult {
    std::string scene;
    Entrant entrant;
    int tetrahedra = 0;
    double msSolver = 0, msLibrary = 0;  ///< medians
    double msLook = 0;                   ///< median, with a ray cast in every frame
    double msExtend = 0;                 ///< median, for one more body that no room was kept for
    double ratio = 1;                    ///< median of each frame's
    int frames = 0;
    std::string skipped;  ///< why it was not measured; empty: it was
};

struct BenchReport {
    std::string processor;
    int cores = 1;
    std::string renderer, glVersion;  ///< empty without a context
    std::vector<BenchResult> results;
    std::vector<PassResult> passes;
    std::vector<DrawingResult> drawn;
    std::vector<LibraryResult> library;
    std::optional<double> msDisplayMeshBuild;  ///< of a wooden wall of 2,000 cells
};

}  // namespace sunder::app
