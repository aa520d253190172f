#include "balance/balanced_solver.hpp"
#include "gpu/gather.hpp"
#include "gpu/scatter.hpp"
#include "gpu/test_context.hpp"
#include "support/solver_under_test.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// Keeps the world's buffers alive, and turns every GL error into a failed test.
template <class GpuSolver>
class Checked : public Solver {
  public:
    explicit Checked(const World& world) : buffers_(world), solver_(world, buffers_) {}
    std::string_view name() const override { return solver_.name(); }
    void advance(int steps) override { solver_.advance(steps); }
    void finish() override { solver_.finish(); }
    void setIncidents(IncidentRing* ring) override { solver_.setIncidents(ring); }
    State state() const override {
        State state = solver_.state();
        testContext().check();
        return state;
    }
    void setState(const State& state) override { solver_.setState(state); }
    void archive(Archive& archive) override {
        solver_.archive(archive);
        testContext().check();
    }
    void push(const Event& event) override { solver_.push(event); }
    void putObject(int object, const ObjectState& state) override {
        solver_.putObject(object, state);
    }
    void setPresent(int body, bool present) override {
        solver_.setPresent(body, present);
        testContext().check();
    }
    bool present(int body) const override { return solver_.present(body); }
    void releaseAnchors(int body) override { solver_.releaseAnchors(body); }
    bool released(int body) const override { return solver_.released(body); }
    std::unique_ptr<StateCopy> makeStateCopy() const override { return solver_.makeStateCopy(); }
    bool setPassObserver(PassObserver* observer) override {
        return solver_.setPassObserver(observer);
    }
    bool asleep(int body) const override { return solver_.asleep(body); }
    bool objectAsleep(int object) const override { return solver_.objectAsleep(object); }

  private:
    gpu::WorldBuffers buffers_;
    GpuSolver solver_;
};

template <class GpuSolver>
std::unique_ptr<Solver> makeChecked(const World& world) {
    testContext();
    return std::make_unique<Checked<GpuSolver>>(world);
}

}  // namespace

std::vector<SolverUnderTest> gpuSolvers() {
    return {{"gather", makeChecked<gpu::GatherSolver>, 6e-8, true, true},
            {"compute", makeChecked<gpu::ComputeSolver>, 6e-8, true, true},
            {"auto", makeChecked<balance::BalancedSolver>, 6e-8, true, true},
            {"scatter", makeChecked<gpu::ScatterSolver>, 6e-8, false, true}};
}
