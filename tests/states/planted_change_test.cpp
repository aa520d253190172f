// A change planted in what a solver computes with is found in the step and the pass that it acts in
// first. When it does is seen in the unchanged run, not counted out beforehand.
#include <functional>
#include <map>

#include "catch.hpp"
#include "states/record.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

constexpr int kSteps = 120;

/// A block on the ground is hit by a ball, and another slides over it.
WorldDescription stacked() {
    WorldDescription description = block({5, 3, 2}, brittle());
    description.bodies.push_back(description.bodies[0]);
    description.bodies[1].position = {0, 0.301, 0.02};
    description.gravity = {0, -9.81, 0};
    description.ground = description.contact = true;
    description.groundFriction = 0;
    description.events = {hit(1, {0, 0.15, 0}, {0, -2, -6})};
    ObjectDescription ball;
    ball.name = "ball";
    ball.position = {0.05, 0.15, 0.3};
    ball.velocity = {0, 0, -8};
    ball.mass = 20;
    description.objects = {ball};
    return description;
}

/// What the unchanged run shows of a step.
struct Seen {
    bool touches = false;        ///< contact of cells changes a force
    bool objectTouches = false;  ///< an object does
    bool damaged = false;        ///< there is a damaged bond
    bool slides = false;         ///< a node does, on the ground
};

/// As numbers, for which -0 N, to which a pass may add nothing, is 0 N.
class Values : public PassObserver {
  public:
    void wrote(std::string_view pass, std::span<const float> values) override {
        std::vector<float>& all = of[std::string(pass)];
        all.insert(all.end(), values.begin(), values.end());
    }
    std::map<std::string, std::vector<float>> of;
};

std::vector<Seen> watch(const World& world, Solver& solver) {
    std::vector<Seen> seen;
    Values passes;
    solver.setPassObserver(&passes);
    for (int step = 1; step <= kSteps; ++step) {
        passes.of.clear();
        solver.advance(1);
        const State state = solver.state();
        Seen now;
        now.touches = passes.of["contacts"] != passes.of["elements"];
        now.objectTouches = passes.of["objects"] != passes.of["contacts"];
        for (const double damage : state.damage) now.damaged |= damage > 0 && damage != kNoBond;
        for (int node = 0; node < world.nodeCount(); ++node) {
            const Vec3& v = state.velocity[node];
            now.slides |= world.restPosition(node)[1] + state.displacement[node][1] == 0 &&
                          (v[0] != 0 || v[2] != 0);
        }
        seen.push_back(now);
    }
    return seen;
}

struct Change {
    const char* what;
    std::function<void(WorldDescription&)> plant;
    const char* pass;                                 ///< that it acts in
    std::function<bool(const Seen&, int step)> acts;  ///< for the first time in this step
};

const Change kChanges[] = {
    {"Young's modulus", [](WorldDescription& d) { d.materials[0].youngModulus *= 1.01; },
     "elements", [](const Seen&, int step) { return step == 2; }},  // nothing is strained before
    {"drag", [](WorldDescription& d) { d.materials[0].damping = 0.5; }, "nodes",
     [](const Seen&, int step) { return step == 2; }},  // nothing moves before
    {"friction of the ground", [](WorldDescription& d) { d.groundFriction = 0.1; }, "nodes",
     [](const Seen& seen, int) { return seen.slides; }},
    {"friction of cells", [](WorldDescription& d) { d.materials[0].friction *= 1.01; }, "contacts",
     [](const Seen& seen, int) { return seen.touches; }},
    {"mass of an object", [](WorldDescription& d) { d.objects[0].mass *= 1.01; }, "objects",
     [](const Seen& seen, int) { return seen.objectTouches; }},
    {"strength",
     [](WorldDescription& d) {
         d.materials[0].strength *= 1.01;
         d.materials[0].boundaryStrength *= 1.01;
     },
     "bonds", [](const Seen& seen, int) { return seen.damaged; }},
    {"length of damage", [](WorldDescription& d) { d.materials[0].damageLength *= 1.01; }, "bonds",
     [](const Seen& seen, int) { return seen.damaged; }},
};

}  // namespace

TEST_CASE("Record: a planted change is found where it acts first") {
    const World world(stacked());
    for (const SolverUnderTest& under : solversUnderTest()) {
        const std::unique_ptr<Solver> solver = under.make(world), watched = under.make(world);
        if (!solver->setPassObserver(nullptr)) continue;
        const Record unchanged = record(*solver, everyStep(kSteps));
        const std::vector<Seen> seen = watch(world, *watched);
        for (const Change& change : kChanges) {
            INFO(change.what << ", " << under.name);
            int first = 1;
            while (first <= kSteps && !change.acts(seen[first - 1], first)) ++first;
            REQUIRE(first <= kSteps);
            WorldDescription description = stacked();
            change.plant(description);
            const World changed(description);
            const std::unique_ptr<Solver> other = under.make(changed);
            CHECK(firstDifference(unchanged, record(*other, everyStep(kSteps)), 50) ==
                  "step " + std::to_string(first) + " (of frame " +
                      std::to_string((first - 1) / 50 + 1) +
                      ") is the first that differs, in the pass `" + change.pass + "`");
        }
    }
}
