// Looking at a world without waiting for it: sim::LateStates, and sim::Simulation that grows.
#include "sim/late_states.hpp"
#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "cpu/cpu_solver.hpp"
#include "sim/simulation.hpp"
#include "support/same_body.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// A solver whose state would have to be waited for, and that counts who does.
class Slow : public cpu::CpuSolver {
  public:
    explicit Slow(const World& world) : CpuSolver(world, 1) {}
    State state() const override {
        ++waits;
        return CpuSolver::state();
    }
    std::unique_ptr<StateCopy> makeStateCopy() const override {
        ++made;
        return std::make_unique<Copy>(*this);
    }
    mutable int waits = 0, copies = 0, made = 0;

  private:
    struct Copy : StateCopy {
        explicit Copy(const Slow& of) : solver(of) {}
        void start() override {
            ++solver.copies;
            state = solver.CpuSolver::state();
        }
        State take() override { return state; }
        const Slow& solver;
        State state;
    };
};

WorldDescription fallingBlock() {
    WorldDescription d = block({2, 2, 2}, softElastic());
    d.gravity = {0, -9.81, 0};
    return d;
}

}  // namespace

TEST_CASE("late states: two frames late, without waiting, and the same ones in every run") {
    const World world(fallingBlock());
    Slow solver(world);
    sim::LateStates late;
    late.setSolver(solver, true);
    CHECK(late.present());  // nothing has been begun
    constexpr int kSteps = 10;
    const auto frame = [&] {
        solver.advance(kSteps);
        late.advanced();
    };
    const auto seen = [&] { return late.look().step / kSteps; };
    for (int i = 0; i < 5; ++i) frame();
    CHECK_FALSE(late.present());
    CHECK(solver.made == 0);  // nobody has looked yet
    CHECK(seen() == 5);
    CHECK(solver.waits == 1);
    // From now on what is seen is what was seen last, until copies are old enough.
    const std::vector<std::int64_t> expected{5, 5, 6, 7, 8};
    for (int i = 0; i < 5; ++i) {
        frame();
        CHECK(seen() == expected[static_cast<std::size_t>(i)]);
        CHECK(seen() == expected[static_cast<std::size_t>(i)]);
    }
    CHECK(solver.waits == 1);
    CHECK(solver.copies == 5);

    // A frame in which nobody looks is no gap; many are, and then nothing is copied.
    frame();
    frame();
    CHECK(seen() == 10);
    CHECK(solver.waits == 1);
    for (int i = 0; i < 2 * sim::LateStates::kPatience; ++i) frame();
    CHECK(solver.copies == 7 + sim::LateStates::kPatience);
    CHECK(seen() == 12 + 2 * sim::LateStates::kPatience);
    CHECK(solver.waits == 2);

    // What was copied before somebody changed the state is of no use.
    frame();
    late.forget();
    CHECK(seen() == 13 + 2 * sim::LateStates::kPatience);
    CHECK(solver.waits == 3);
    late.finished();
    CHECK(late.present());
    frame();
    CHECK_FALSE(late.present());
}

TEST_CASE("late states: a solver that need not be waited for has none") {
    const World world(fallingBlock());
    cpu::CpuSolver solver(world, 1);
    sim::LateStates late;
    late.setSolver(solver, false);
    solver.advance(10);
    late.advanced();
    CHECK(late.present());
}

TEST_CASE("a simulation goes on in a larger world from where it was") {
    WorldDescription small = block({3, 2, 2}, brittle());
    small.bodies[0].anchors = {Side::Bottom};
    small.gravity = {0, -9.81, 0};
    small.ground = small.contact = true;
    BodyDescription gone = small.bodies[0];
    gone.name = "gone";
    gone.position = {3, 0, 0};
    small.bodies.push_back(gone);
    small.events = {hit(0, {0, 0.2, 0}, {0, 0, 6})};
    WorldDescription large = small;
    large.materials.push_back(softElastic());
    BodyDescription loose = small.bodies[0];
    loose.name = "loose";
    loose.anchors.clear();
    loose.material = 1;
    loose.position = {-3, 0.1, 0};
    BodyDescription later = loose;
    later.name = "later";
    later.position = {-6, 0.1, 0};
    later.present = false;
    large.bodies.insert(large.bodies.end(), {loose, later});
    for (const sim::SolverInfo& info : sim::cpuSolvers()) {
        INFO(info.name);
        sim::Simulation simulation(std::make_shared<sim::Layout>(small), info, 1, 100);
        simulation.setPresent(1, false);
        simulation.advance(41);
        simulation.releaseAnchors(0);
        const State before = simulation.state();
        CHECK(diagnose(simulation.world(), before).bondsBroken > 0);
        const auto larger = std::make_shared<sim::Layout>(large);
        simulation.extend(larger);
        CHECK(simulation.step() == 41);
        CHECK(&simulation.world() == &larger->world());
        const State after = simulation.state();
        for (int body = 0; body < 2; ++body) CHECK(sameBody(larger->world(), after, before, body));
        CHECK(after.absent == std::vector{1, 3});
        CHECK(after.released == std::vector{0});
        CHECK(after.step == before.step);
        const State initial = larger->world().initialState();
        CHECK(sameBody(larger->world(), after, initial, 2));
        simulation.advance(59);
        // 20 ms of fall are 2 mm.
        CHECK(simulation.state().displacement[kCorners * larger->world().bodies()[2].firstCell][1] <
              -1e-3);
        CHECK_FALSE(simulation.present(3));
        simulation.setPresent(3, true);
        CHECK(simulation.present(3));
        simulation.restart();
        CHECK(simulation.state().displacement.size() ==
              static_cast<std::size_t>(larger->world().nodeCount()));
    }
}
