#include "gpu/scatter.hpp"
#include "gpu/test_context.hpp"
#include "support/solver_under_test.hpp"

using namespace sunder;

gl::Context& testContext() {
    static const std::unique_ptr<gl::Context> context = gl::createHeadlessContext();
    return *context;
}

namespace {

/// Keeps the world's buffers alive, and turns every GL error into a failed test.
class CheckedScatter : public Solver {
  public:
    explicit CheckedScatter(const World& world) : buffers_(world), solver_(world, buffers_) {}
    std::string_view name() const override { return solver_.name(); }
    void advance(int steps) override { solver_.advance(steps); }
    State state() const override {
        State state = solver_.state();
        testContext().check();
        return state;
    }
    void setState(const State& state) override { solver_.setState(state); }

  private:
    gpu::WorldBuffers buffers_;
    gpu::ScatterSolver solver_;
};

}  // namespace

std::vector<SolverUnderTest> solversUnderTest() {
    return {{"scatter",
             [](const World& world) {
                 testContext();
                 return std::make_unique<CheckedScatter>(world);
             },
             6e-8}};
}
