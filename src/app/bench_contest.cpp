#include "app/bench_contest.hpp"

#include <algorithm>
#include <cmath>

#include "app/bench_table.hpp"
#include "app/machine.hpp"
#include "app/progress.hpp"
#include "app/start.hpp"
#include "app/stopwatch.hpp"
#include "sim_gl/drawn_state.hpp"

namespace sunder::app {

using namespace core;

namespace {

constexpr double kGpuWarmUp = 0.3;  // s

double brokenShare(const World& world, const State& state) {
    if (world.bondCount() == 0) return 0;
    const auto broken = std::count_if(state.damage.begin(), state.damage.end(), [](double damage) {
        return damage >= 1 && damage < kNoBond;
    });
    return static_cast<double>(broken) / world.bondCount();
}

}  // namespace

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

int fewestSteps(const WorldDescription& world) {
    const int interval = world.fractureInterval > 0 ? world.fractureInterval : kLookSteps;
    return interval * std::max(1, 8 / interval);
}

std::string Entrant::label() const {
    if (!solver->threaded) return solver->name;
    return solver->name + ", " + std::to_string(threads) + (threads == 1 ? " thread" : " threads");
}

Contest::Contest(scene::Scene scene, const std::vector<Entrant>& entrants,
                 const BenchLimits& limits, const window::Context* context)
    : scene_(std::move(scene)),
      layout_(std::make_shared<sim_gl::GlLayout>(scene_.world)),
      limits_(limits),
      software_(context && context->info().software) {
    std::string problem;
    if (context) {
        const std::size_t before = gl::allocatedBytes();
        try {
            layout_->upload();
        } catch (const InputError& error) {
            problem = error.what();
        }
        worldBytes_ = gl::allocatedBytes() - before;
    }
    for (const Entrant& entrant : entrants) {
        Lane& lane = lanes_.emplace_back();
        lane.entrant = entrant;
        if (entrant.solver->gpu) lane.skipped = problem;
        if (lane.skipped.empty()) makeSimulation(lane);
    }
}

void Contest::makeSimulation(Lane& lane) {
    const sim::SolverInfo& info = *lane.entrant.solver;
    const std::size_t before = info.gpu ? gl::allocatedBytes() : heapBytesInUse().value_or(0);
    try {
        lane.simulation = std::make_unique<sim::Simulation>(layout_, info, lane.entrant.threads);
    } catch (const InputError& error) {
        lane.skipped = error.what();
        return;
    }
    const double tetrahedra = kTetrahedraPerCell * double(world().presentCells());
    if (info.gpu)
        lane.bytes = static_cast<double>(gl::allocatedBytes() - before + worldBytes_) / tetrahedra;
    else if (const auto after = heapBytesInUse(); after && *after > before)
        lane.bytes = static_cast<double>(*after - before) / tetrahedra;
}

const State& Contest::start() {
    if (!start_) start_ = startOf(scene_, world());
    return *start_;
}

int Contest::leadSteps(const State& start) const {
    double firstEnd = static_cast<double>(start.step);
    if (!world().events().empty())
        firstEnd = std::min_element(world().events().begin(), world().events().end(),
                                    [](const Event& a, const Event& b) { return a.end < b.end; })
                       ->end;
    const double steps = std::ceil(firstEnd - static_cast<double>(start.step));
    return static_cast<int>(std::clamp(steps, 0.0, double(scene_.substeps)));
}

void Contest::prepare(Lane& lane, const State& start) const {
    lane.simulation->setState(start);
    if (lane.entrant.solver->gpu && !software_) {
        // A GPU that idled while a CPU solver ran has lowered its clocks: a quarter of the speed.
        const Stopwatch watch;
        while (watch.seconds() < kGpuWarmUp) timedRun(lane, scene_.substeps);
        lane.simulation->setState(start);
    }
    settle(lane, start);
    const int lead = leadSteps(start);
    if (lead > 0 && lead * lane.stepSeconds < limits_.secondsPerRun) lane.simulation->advance(lead);
    lane.simulation->finish();
}

void Contest::settle(Lane& lane, const State& start) const {
    const Stopwatch watch;
    // Again and again from the start: what comes to rest and sleeps is no load.
    while (!lane.simulation->solver().settled() && watch.seconds() < limits_.secondsPerCell) {
        timedRun(lane, scene_.substeps);
        lane.simulation->setState(start);
    }
}

double Contest::timedRun(Lane& lane, int steps) const {
    const Stopwatch watch;
    for (int left = steps; left > 0; left -= scene_.substeps)
        lane.simulation->advance(std::min(left, scene_.substeps));
    lane.simulation->finish();
    return watch.seconds();
}

void Contest::probe(Lane& lane, const State& start) {
    const int steps = fewestSteps(scene_.world);
    const auto tooSlow = [&] {
        if (steps * lane.stepSeconds < limits_.secondsPerCell) return false;
        lane.skipped = std::to_string(steps) + " steps take about " +
                       shortNumber(steps * lane.stepSeconds) + " s";
        return true;
    };
    lane.simulation->setState(start);
    lane.simulation->finish();
    // Drivers compile shaders at their first use: step 0 tests fracture, step 1 does not, and the
    // steps after an event may take others still.
    for (int i = 0; i < 2; ++i) timedRun(lane, 1);
    lane.stepSeconds = std::min(timedRun(lane, 1), timedRun(lane, 1));
    if (tooSlow()) return;
    prepare(lane, start);
    lane.stepSeconds = std::min(timedRun(lane, steps), timedRun(lane, steps)) / steps;
    tooSlow();
}

int Contest::stepsPerRun(const Lane& lane) const {
    const double seconds =
        std::min(limits_.secondsPerRun, limits_.secondsPerCell / limits_.repeats);
    const int frame = scene_.substeps, interval = world().fractureInterval();
    const double most = double(limits_.framesPerRun) * frame;
    int steps = static_cast<int>(std::min(seconds / std::max(lane.stepSeconds, 1e-9), most));
    steps -= steps % (steps >= frame ? frame : interval);
    return std::max(steps, fewestSteps(scene_.world));
}

std::vector<BenchResult> Contest::measure(const std::string& part, const State& start) {
    std::vector<std::vector<double>> samples(lanes_.size());
    Progress progress(part + ", " + scene_.name, limits_.repeats + 1);
    for (Lane& lane : lanes_)
        if (lane.skipped.empty()) probe(lane, start);
    for (int repeat = 0; repeat < limits_.repeats; ++repeat) {
        progress.update(repeat + 1);
        for (std::size_t i = 0; i < lanes_.size(); ++i) {
            Lane& lane = lanes_[i];
            if (!lane.skipped.empty()) continue;
            const int steps = stepsPerRun(lane);
            // A few steps that take long need fewer repeats to tell how long.
            if (repeat * steps * lane.stepSeconds > limits_.secondsPerCell) continue;
            prepare(lane, start);
            samples[i].push_back(1000 * timedRun(lane, steps) / steps);
        }
    }
    std::vector<BenchResult> results;
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
        const Lane& lane = lanes_[i];
        BenchResult& result = results.emplace_back();
        result.part = part;
        result.scene = scene_.name;
        result.label = lane.entrant.label();
        result.solver = lane.entrant.solver->name;
        result.threads = lane.entrant.threads;
        result.bodies = static_cast<int>(world().bodies().size());
        result.tetrahedra = kTetrahedraPerCell * world().presentCells();
        result.stepsPerFrame = scene_.substeps;
        for (const ElementLaw& law : world().laws()) result.stiffnessLimited |= law.limited;
        result.msPerStep = median(samples[i]);
        result.runs = static_cast<int>(samples[i].size());
        result.stepsPerRun = result.runs ? stepsPerRun(lane) : 0;
        result.bytesPerTetrahedron = lane.bytes;
        result.bondsBroken = brokenShare(world(), start);
        result.skipped = lane.skipped;
    }
    return results;
}

void Contest::measureDrawn(std::vector<BenchResult>& results) {
    if (!layout_->buffers()) return;
    const State& start = this->start();
    const render::RenderSettings settings{.width = 1280, .height = 720};
    render::Renderer renderer(world(), *layout_->buffers());
    std::vector<std::unique_ptr<sim_gl::DrawnState>> drawn(lanes_.size());
    std::vector<std::vector<double>> samples(lanes_.size());
    std::vector<double> frameSeconds(lanes_.size());
    const auto frame = [&](std::size_t i) {
        lanes_[i].simulation->advance(scene_.substeps);
        renderer.draw(drawn[i]->view(), scene_.camera, settings);
    };
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
        if (!lanes_[i].skipped.empty()) continue;
        drawn[i] = std::make_unique<sim_gl::DrawnState>(*lanes_[i].simulation);
        if (scene_.substeps * lanes_[i].stepSeconds > limits_.secondsPerCell) continue;
        prepare(lanes_[i], start);
        frame(i);
        const Stopwatch watch;
        frame(i);
        frameSeconds[i] = watch.seconds();
    }
    Progress progress("drawn, " + scene_.name, limits_.repeats);
    for (int repeat = 0; repeat < limits_.repeats; ++repeat) {
        progress.update(repeat);
        for (std::size_t i = 0; i < lanes_.size(); ++i) {
            if (frameSeconds[i] == 0 || repeat * frameSeconds[i] > limits_.secondsPerCell) continue;
            const int frames = std::clamp(static_cast<int>(limits_.secondsPerRun / frameSeconds[i]),
                                          1, limits_.drawnFramesPerRun);
            prepare(lanes_[i], start);
            const Stopwatch watch;
            for (int k = 0; k < frames; ++k) frame(i);
            samples[i].push_back(1000 * watch.seconds() / frames);
        }
    }
    for (std::size_t i = 0; i < lanes_.size(); ++i)
        if (!samples[i].empty()) results[i].msPerFrameDrawn = median(samples[i]);
}

int Contest::breakingFrames(Lane& lane, const State& start) const {
    lane.simulation->setState(start);
    int last = 0;
    double before = brokenShare(world(), start);
    for (int frame = 1; frame <= limits_.framesPerRun; ++frame) {
        lane.simulation->advance(scene_.substeps);
        const double now = brokenShare(world(), lane.simulation->state());
        if (now > before) last = frame;
        before = now;
    }
    return last;
}

void Contest::measureBreaking(std::vector<BenchResult>& results) {
    const State& start = this->start();
    std::vector<std::vector<std::vector<double>>> samples(lanes_.size());  // [lane][frame][repeat]
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
        Lane& lane = lanes_[i];
        const double seconds = limits_.framesPerRun * scene_.substeps * lane.stepSeconds;
        if (lane.skipped.empty() && seconds * limits_.repeats < limits_.secondsPerCell)
            samples[i].resize(static_cast<std::size_t>(breakingFrames(lane, start)));
    }
    Progress progress("breaking, " + scene_.name, limits_.repeats);
    for (int repeat = 0; repeat < limits_.repeats; ++repeat) {
        progress.update(repeat);
        for (std::size_t i = 0; i < lanes_.size(); ++i) {
            if (samples[i].empty()) continue;
            prepare(lanes_[i], start);
            lanes_[i].simulation->setState(start);
            lanes_[i].simulation->finish();
            for (std::vector<double>& frame : samples[i])
                frame.push_back(1000 * timedRun(lanes_[i], scene_.substeps));
        }
    }
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
        if (samples[i].empty()) continue;
        std::vector<double> frames;
        for (const std::vector<double>& frame : samples[i]) frames.push_back(median(frame));
        results[i].msPerFrameBreaking = median(frames);
        results[i].msPerFrameWorst = *std::max_element(frames.begin(), frames.end());
    }
}

std::vector<PassResult> Contest::measurePasses() {
    std::vector<PassResult> results;
    const State& start = this->start();
    for (Lane& lane : lanes_) {
        if (!lane.skipped.empty() || !lane.simulation->gpuSolver()) continue;
        prepare(lane, start);
        gpu::PassTimer timer(software_);
        const int steps = std::min(stepsPerRun(lane), scene_.substeps);
        lane.simulation->gpuSolver()->setPassTimer(&timer);
        timedRun(lane, steps);
        lane.simulation->gpuSolver()->setPassTimer(nullptr);
        for (const gpu::PassTimer::Times& times : timer.take())
            results.push_back({scene_.name, lane.entrant.solver->name, times.pass,
                               kTetrahedraPerCell * world().presentCells(),
                               median(times.milliseconds),
                               double(times.milliseconds.size()) * scene_.substeps / steps});
    }
    return results;
}

State Contest::stateAfter(int frames) {
    Lane* fastest = nullptr;
    for (Lane& lane : lanes_)
        if (lane.skipped.empty() && (!fastest || lane.stepSeconds < fastest->stepSeconds))
            fastest = &lane;
    if (!fastest) return start();
    const int steps = static_cast<int>(
        std::min(double(frames) * scene_.substeps, limits_.secondsPerCell / fastest->stepSeconds));
    fastest->simulation->setState(start());
    timedRun(*fastest, std::max(steps, scene_.substeps));
    return fastest->simulation->state();
}

}  // namespace sunder::app
