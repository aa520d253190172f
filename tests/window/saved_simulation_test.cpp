// Saving a Simulation and going back (sim/simulation.hpp), on solvers that need no context.
#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "scene/scene.hpp"
#include "sim/simulation.hpp"
#include "support/same_body.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

WorldDescription described() {
    WorldDescription world = scene::parseScene(R"(
[contact]
enabled = true
[[body]]
name = "wall"
material = "glass"
size = [0.7, 0.5, 0.2]
cells = [7, 5, 2]
anchor = ["bottom"]
[[object]]
name = "ball"
shape = "sphere"
radius = 0.1
mass = 9
position = [0, 0.3, 0.25]
velocity = [0, 0, -15]
)",
                                               "saved.toml", {})
                                 .world;
    return world;
}

EventDescription push() {
    EventDescription push;
    push.kind = EventDescription::Kind::Velocity;
    push.point = {0.1, 0.4, 0};
    push.radius = 0.2;
    push.vector = {0, 0, 6};
    return push;
}

}  // namespace

TEST_CASE("a simulation goes back to what it saved, and another one on from there") {
    for (const sim::SolverInfo& info : sim::cpuSolvers()) {
        INFO(info.name);
        const auto layout = std::make_shared<sim::Layout>(described());
        sim::Simulation first(layout, info, 1, 100);
        // Its own layout of an equal world, and other threads.
        sim::Simulation second(std::make_shared<sim::Layout>(described()), info, 3, 100);
        first.restart();
        first.push(push());
        first.advance(37);
        const std::uint64_t between = stateHash(first.state());
        const std::vector<std::byte> saved = first.saveState();
        first.advance(63);
        const std::uint64_t end = stateHash(first.state());
        CHECK(diagnose(first.world(), first.state()).bondsBroken > 0);
        const std::vector<Incident> found = first.takeIncidents();
        CHECK(!found.empty());

        first.restoreState(saved);
        CHECK(first.step() == 37);
        CHECK(stateHash(first.state()) == between);  // not what it had fetched before
        CHECK(first.state().step == 37);
        first.advance(63);
        CHECK(stateHash(first.state()) == end);
        CHECK(first.takeIncidents().size() == found.size());

        second.advance(5);
        second.restoreState(saved);
        CHECK(second.step() == 37);
        second.advance(63);
        CHECK(stateHash(second.state()) == end);
        CHECK(second.takeIncidents().size() == found.size());

        // A push begins with the next step after the one that was restored.
        second.restoreState(saved);
        second.push(push());
        CHECK(second.state().pushes.size() == first.state().pushes.size() + 1);
        CHECK(second.state().pushes.back().start == 37);
        second.advance(63);
        CHECK(stateHash(second.state()) != end);
    }
}

TEST_CASE("a simulation that is given bytes of another solver stays as it is") {
    const auto layout = std::make_shared<sim::Layout>(described());
    const auto solvers = sim::cpuSolvers();
    sim::Simulation one(layout, solvers[0]), other(layout, solvers[1]);
    one.advance(9);
    other.advance(4);
    const std::uint64_t before = stateHash(other.state());
    CHECK_THROWS_AS(other.restoreState(one.saveState()), InputError);
    CHECK(other.step() == 4);
    CHECK(stateHash(other.state()) == before);
    other.advance(1);
    CHECK(other.state().step == 5);
}

TEST_CASE(
    "a simulation adds and removes bodies where contacts are searched for, and others never know") {
    WorldDescription description = described();
    BodyDescription visitor = description.bodies[0];
    visitor.name = "visitor";
    visitor.anchors.clear();
    visitor.position = {5, 0.2, 0};
    visitor.present = false;
    description.bodies.push_back(visitor);
    EventDescription pushed = push();
    pushed.body = 1;
    pushed.radius = 2;  // all of it
    for (const sim::SolverInfo& info : sim::cpuSolvers()) {
        INFO(info.name);
        const auto layout = std::make_shared<sim::Layout>(description);
        sim::Simulation alone(layout, info, 1), visited(layout, info, 1), second(layout, info, 1);
        const int visitorNode = kCorners * layout->world().bodies()[1].firstCell;
        const auto visitorSpeed = [&] { return visited.state().velocity[visitorNode][2]; };
        const auto both = [&](int steps) {
            alone.advance(steps);
            visited.advance(steps);
        };
        const auto sameWall = [&] {
            return sameBody(layout->world(), alone.state(), visited.state(), 0) &&
                   alone.state().objects == visited.state().objects;
        };
        alone.restart();
        visited.restart();
        both(37);
        visited.setPresent(1, true);
        visited.push(pushed);
        CHECK(visited.present(1));
        CHECK_FALSE(visited.solver().present(1));
        both(2);
        CHECK_FALSE(visited.solver().present(1));
        const std::vector<std::byte> saved = visited.saveState();
        both(1);
        CHECK(visited.step() == 40);
        CHECK(visited.solver().present(1));
        CHECK(visitorSpeed() == 0);
        both(23);
        // Were it free, it would have all of the push's 6 m/s after 5 ms; the material damps it.
        CHECK(visitorSpeed() > 3);
        CHECK(sameWall());

        // What was still to come is among what was saved.
        second.restoreState(saved);
        CHECK(second.present(1));
        second.advance(24);
        CHECK(stateHash(second.state()) == stateHash(visited.state()));
        second.setState(alone.state());
        CHECK_FALSE(second.present(1));

        // It goes, is whole again at once if it also comes, and nothing happens twice.
        visited.setPresent(1, false);
        CHECK_FALSE(visited.present(1));
        visited.setPresent(1, true);
        both(2);
        CHECK(visited.present(1));
        CHECK(visitorSpeed() == 0);
        both(4);
        visited.setPresent(1, false);
        both(10);
        CHECK_FALSE(visited.solver().present(1));
        visited.setPresent(1, true);
        visited.setPresent(1, false);
        both(37);
        CHECK_FALSE(visited.solver().present(1));
        CHECK(diagnose(layout->world(), alone.state()).bondsBroken > 0);
        CHECK(sameWall());
        CHECK(stateHash(alone.state()) == stateHash(visited.state()));
    }
}
