// Saved states (core/saved_state.hpp): what goes on from one does so to the bit, and what is not
// one is refused.
#include "core/saved_state.hpp"

#include <algorithm>
#include <cstring>

#include "catch.hpp"
#include "core/diagnostics.hpp"
#include "core/incident.hpp"
#include "support/object_worlds.hpp"
#include "support/solver_under_test.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

using Bytes = std::vector<std::byte>;

/// Where two states differ first: everything that a solver knows, and not only what State shows.
/// The checksums would tell less.
std::ptrdiff_t firstDifference(const Bytes& a, const Bytes& b) {
    if (a.size() != b.size()) return static_cast<std::ptrdiff_t>(std::min(a.size(), b.size()));
    const auto at = std::mismatch(a.begin(), a.end(), b.begin()).first;
    return at == a.end() ? -1 : at - a.begin();
}

EventDescription atStep(EventDescription event, double step, double h) {
    event.time = step * h;
    return event;
}

/// A wall with a hole and a loose one behind it, which break; long and heavy cells on top of them,
/// which bear several spheres each and ask for forces of constraint; a wall that breaks by cells
/// and whose stiffness is limited; a ball that hits, one on a chain, a box that comes flying.
WorldDescription breaking() {
    WorldDescription d = block({5, 4, 2}, brittle());
    d.bodies[0].anchors = {Side::Bottom};
    d.bodies[0].regions = {{{1, 1, 0}, {1, 2, 1}, -1}};
    BodyDescription loose = d.bodies[0];
    loose.name = "loose";
    loose.anchors.clear();
    loose.position = {0.03, 0, 0.25};
    Material heavy = brittle();
    heavy.density = 2e4;
    BodyDescription stones = loose;
    stones.name = "stones";
    stones.regions.clear();
    stones.size = {0.6, 0.1, 0.1};
    stones.cells = {2, 1, 1};
    stones.position = {0, 0.41, 0.05};
    stones.material = 1;
    Material cells = brittle();
    cells.fracture = FractureMode::Cell;
    cells.youngModulus = 1e10;
    cells.maxStress = 2e4;
    BodyDescription third = stones;
    third.name = "third";
    third.size = {0.3, 0.3, 0.2};
    third.cells = {3, 3, 2};
    third.position = {0.5, 0, 0};
    third.material = 2;
    third.anchors = {Side::Bottom};
    d.bodies.insert(d.bodies.end(), {loose, stones, third});
    d.materials.insert(d.materials.end(), {heavy, cells});
    d.gravity = {0, -9.81, 0};
    d.ground = d.contact = true;
    d.objects = {ball(0.1, 20, {0.1, 0.2, 0.55}, {0, 0, -25}),
                 ball(0.08, 5, {0.4, 0.3, 0.35}, {0, 0, -9}),
                 shaped(ObjectShape::Box, {0.05, 0.05, 0.05}, 1, {0, 0, 0}, {0, 0, 0})};
    d.objects[1].hungFrom = Vec3(0.4, 1, 0.35);
    d.objects[2].position.reset();  // until it is thrown
    d.throws = {{17 * d.step, 2, {-0.4, 0.15, 0.1}, {12, 0, 0}, {0, 3, 0}}};
    d.events = {atStep(hit(3, {0, 0.2, 0}, {0, 0, -14}), 11.5, d.step)};
    return d;
}

/// While time runs: one is over soon, one is under way for long, one is yet to come.
std::vector<EventDescription> pushes(double h) {
    EventDescription blast = atStep(hit(kEveryBody, {0.1, 0.2, 0.1}, {0, 2, 0}), 30, h);
    blast.radius = 0.4;
    blast.outward = 9;
    blast.falloff = true;
    EventDescription force = atStep(hit(1, {-0.1, 0.2, 0.1}, {0, 0, 700}), 6.25, h);
    force.kind = EventDescription::Kind::Force;
    force.duration = 50 * h;
    return {atStep(hit(0, {0.2, 0.3, 0.1}, {0, 1, -9}), 4, h), force, blast};
}

/// Half a second are 300 steps.
constexpr double kLongStep = 1.0 / 600;

/// Blocks and objects that come to rest and sleep. In the midst of the steps between two searches
/// the first block is pushed, a box on it, against the second one, which lies near; a box that lies
/// apart is thrown at the third; a blast wakes the fourth, which a box carries. A ball hangs still.
WorldDescription resting() {
    Material material = softElastic();
    material.youngModulus = 1e9;  // as stiff as the step allows
    material.damping = 10;
    WorldDescription d = block({2, 2, 2}, material);
    d.step = kLongStep;
    const auto add = [&](const char* name, const Vec3& position) {
        d.bodies.push_back(d.bodies[0]);
        d.bodies.back().name = name;
        d.bodies.back().position = position;
    };
    add("near", {-0.23, 0, 0});
    add("third", {1, 0, 0});
    add("carried", {5, 0.3, 0});
    d.gravity = {0, -9.81, 0};
    d.ground = d.contact = true;
    const auto box = [](const Vec3& halfSize, const Vec3& position) {
        return shaped(ObjectShape::Box, halfSize, 2, position, {0, 0, 0});
    };
    d.objects = {box({0.08, 0.05, 0.08}, {0, 0.25, 0}), box({0.05, 0.05, 0.05}, {2, 0.05, 0}),
                 box({0.2, 0.15, 0.2}, {5, 0.15, 0}), ball(0.1, 1, {3, 1, 0}, {0, 0, 0})};
    d.objects[3].hungFrom = Vec3(3, 2, 0);
    EventDescription blast = atStep(hit(kEveryBody, {5, 0.6, 0}, {0, 0, 0}), 940.3, d.step);
    blast.radius = 0.3;
    blast.outward = 0.5;
    d.events = {atStep(hit(0, {0, 0.1, 0}, {-2, 0.5, 0}), 906.6, d.step), blast};
    d.throws = {{925 * d.step, 1, {1.5, 0.1, 0}, {-20, 0, 0}, {0, 0, 0}}};
    return d;
}

/// Advances by single steps and saves after each: [0] as it is.
std::vector<Bytes> saveEachStep(const World& world, Solver& solver, int steps) {
    std::vector<Bytes> saved{saveState(world, solver)};
    for (int i = 0; i < steps; ++i) {
        solver.advance(1);
        saved.push_back(saveState(world, solver));
    }
    return saved;
}

}  // namespace

TEST_CASE("a state saved after any step of a break goes on to the bit") {
    const World world(breaking());
    REQUIRE(world.unequalCells());
    constexpr int kSteps = 36, kFurther = 9;
    for (const SolverUnderTest& under : exactSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world), plain = under.make(world), other = under.make(world);
        for (const EventDescription& event : pushes(world.step())) {
            solver->push(world.makeEvent(event));
            plain->push(world.makeEvent(event));
        }
        const std::vector<Bytes> saved = saveEachStep(world, *solver, kSteps + kFurther);
        // Saving has changed nothing.
        for (int i = 0; i < kSteps + kFurther; ++i) plain->advance(1);
        CHECK(firstDifference(saveState(world, *plain), saved.back()) == -1);
        const Diagnostics end = diagnose(world, plain->state());
        CHECK(end.nan == 0);
        CHECK(end.bondsBroken > 20);
        // Not in order, so that each time nearly everything is another than before.
        for (int i = 0; i <= kSteps; ++i) {
            const int step = 22 * i % (kSteps + 1);
            CAPTURE(step);
            CHECK(restoreState(world, *other, saved[step]) == step);
            REQUIRE(firstDifference(saveState(world, *other), saved[step]) == -1);
            other->advance(kFurther);
            REQUIRE(firstDifference(saveState(world, *other), saved[step + kFurther]) == -1);
        }
        // And nothing of it came from what the other one had had.
        const auto fresh = under.make(world);
        restoreState(world, *fresh, saved[kSteps]);
        fresh->advance(kFurther);
        CHECK(stateHash(fresh->state()) == stateHash(plain->state()));
        CHECK(firstDifference(saveState(world, *fresh), saved.back()) == -1);
    }
}

TEST_CASE("a state saved while things fall asleep, sleep and wake goes on to the bit") {
    const World world(resting());
    constexpr int kSteps = 1000, kFurther = 13;
    const auto asleepOf = [&](const Solver& solver) {
        int count = 0;
        for (int i = 0; i < 4; ++i) count += solver.asleep(i) + solver.objectAsleep(i);
        return count;
    };
    for (const SolverUnderTest& under : exactSolvers()) {
        if (!under.sleeps) continue;
        INFO(under.name);
        const auto solver = under.make(world);
        std::vector<Bytes> saved{saveState(world, *solver)};
        std::vector<int> asleep{0};  // how many, per step
        for (int i = 0; i < kSteps; ++i) {
            solver->advance(1);
            saved.push_back(saveState(world, *solver));
            asleep.push_back(asleepOf(*solver));
        }
        CHECK(asleep[900] == 8);
        CHECK(asleep[920] <= 6);
        CHECK(asleep[980] == 1);  // the ball hangs
        std::vector<int> from;
        for (int step = 0; step + kFurther <= kSteps; ++step) {
            const bool soon = asleep[step] != asleep[step + kFurther];
            if (soon || step % 61 == 0) from.push_back(step);
        }
        const auto count = static_cast<int>(from.size());
        CHECK(count > 50);
        auto other = under.make(world);
        // Not in order, and now and then into one that knows nothing.
        for (int i = 0; i < count; ++i) {
            const int step = from[static_cast<std::size_t>(41 * i % count)];
            CAPTURE(step);
            if (i % 10 == 0) other = under.make(world);
            restoreState(world, *other, saved[step]);
            REQUIRE(firstDifference(saveState(world, *other), saved[step]) == -1);
            // One by one: a body wakes as early as the steps of one advance() and a search allow.
            for (int k = 0; k < kFurther; ++k) other->advance(1);
            REQUIRE(firstDifference(saveState(world, *other), saved[step + kFurther]) == -1);
            CHECK(asleepOf(*other) == asleep[step + kFurther]);
        }
    }
}

TEST_CASE("back in time the same comes again, and another push makes another future") {
    const World world(breaking());
    for (const SolverUnderTest& under : exactSolvers()) {
        INFO(under.name);
        const auto solver = under.make(world);
        for (const EventDescription& event : pushes(world.step()))
            solver->push(world.makeEvent(event));
        solver->advance(22);
        const Bytes before = saveState(world, *solver);
        solver->advance(30);
        const Bytes after = saveState(world, *solver);
        CHECK(restoreState(world, *solver, before) == 22);
        solver->advance(30);
        CHECK(firstDifference(saveState(world, *solver), after) == -1);

        const Event push =
            world.makeEvent(atStep(hit(1, {0, 0.2, 0.1}, {0, 0, 5}), 25, world.step()));
        restoreState(world, *solver, before);
        solver->push(push);
        solver->advance(30);
        const Bytes pushed = saveState(world, *solver);
        CHECK(firstDifference(pushed, after) != -1);
        const auto other = under.make(world);
        restoreState(world, *other, before);
        other->push(push);
        other->advance(30);
        CHECK(firstDifference(saveState(world, *other), pushed) == -1);
        // What was pushed since is forgotten.
        restoreState(world, *solver, before);
        solver->advance(30);
        CHECK(firstDifference(saveState(world, *solver), after) == -1);
    }
}

TEST_CASE("what State holds is restored by every solver, auto among them, and goes on") {
    const World world(breaking());
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        const auto solver = under.make(world), other = under.make(world);
        for (const EventDescription& event : pushes(world.step()))
            solver->push(world.makeEvent(event));
        for (int frame = 0; frame < 5; ++frame) solver->advance(7);
        const Bytes saved = saveState(world, *solver);
        const State state = solver->state();
        CHECK(diagnose(world, state).bondsBroken > 0);
        CHECK(restoreState(world, *other, saved) == 35);
        const State restored = other->state();
        CHECK(restored.step == 35);
        CHECK(stateHash(restored) == stateHash(state));
        CHECK(restored.damage == state.damage);
        CHECK(restored.slow == state.slow);
        CHECK(restored.slowStress == state.slowStress);
        CHECK(restored.objects == state.objects);
        CHECK(restored.pushes.size() == 2);
        other->advance(20);
        CHECK(other->state().step == 55);
        CHECK(diagnose(world, other->state()).nan == 0);
    }
}

TEST_CASE("after a state is restored the same incidents are found") {
    WorldDescription d = breaking();
    const World world(d);
    for (const SolverUnderTest& under : exactSolvers()) {
        INFO(under.name);
        IncidentRing ring, otherRing;
        const auto solver = under.make(world), other = under.make(world);
        solver->setIncidents(&ring);
        other->setIncidents(&otherRing);
        solver->advance(73);  // looks are at 50 and 100
        const Bytes saved = saveState(world, *solver);
        ring.take();
        solver->advance(90);
        solver->finish();
        const std::vector<Incident> expected = ring.take();
        CHECK(expected.size() > 5);
        other->advance(10);  // something else was going on there
        restoreState(world, *other, saved);
        otherRing.take();
        other->advance(90);
        other->finish();
        const std::vector<Incident> found = otherRing.take();
        REQUIRE(found.size() == expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            CAPTURE(i);
            CHECK(found[i].kind == expected[i].kind);
            CHECK(found[i].step == expected[i].step);
            CHECK(found[i].cell == expected[i].cell);
            CHECK(found[i].other == expected[i].other);
            CHECK(found[i].object == expected[i].object);
            CHECK(found[i].place == expected[i].place);
            CHECK(found[i].impulse == expected[i].impulse);
        }
        // Whether somebody looks changes nothing else.
        const auto unwatched = under.make(world);
        restoreState(world, *unwatched, saved);
        unwatched->advance(90);
        CHECK(stateHash(unwatched->state()) == stateHash(other->state()));
        const Bytes silent = saveState(world, *unwatched);
        restoreState(world, *other, silent);
        otherRing.take();
        other->advance(50);
        other->finish();
        for (const Incident& incident : otherRing.take()) CHECK(incident.step == 200);
    }
}

TEST_CASE("bytes that are no saved state of this solver and world are refused in one sentence") {
    WorldDescription d = breaking();
    const World world(d);
    d.bodies[1].position[0] += 0.01;
    const World moved(d);
    d = breaking();
    d.materials[0].strength *= 1.01;
    const World stronger(d);
    d = breaking();
    d.groundFriction += 0.1;
    const World rougher(d);
    for (const World* other : {&moved, &stronger, &rougher})
        CHECK(other->fingerprint() != world.fingerprint());
    CHECK(World(breaking()).fingerprint() == world.fingerprint());
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        const auto solver = under.make(world);
        solver->advance(21);
        const Bytes good = saveState(world, *solver);
        solver->advance(5);
        const Bytes now = saveState(world, *solver);
        struct Case {
            const char* what;
            Bytes bytes;
            std::string says;
        };
        std::vector<Case> cases;
        const auto add = [&](const char* what, std::string says, const auto& change) {
            Bytes bytes = good;
            change(bytes);
            cases.push_back({what, std::move(bytes), std::move(says)});
        };
        add("nothing", "does not begin as", [](Bytes& bytes) { bytes.clear(); });
        add("text", "does not begin as", [](Bytes& bytes) { bytes[3] = std::byte{'x'}; });
        add("the magic alone", "only 8 bytes", [](Bytes& bytes) { bytes.resize(8); });
        add("less than a header", "only 40 bytes", [](Bytes& bytes) { bytes.resize(40); });
        add("cut", "instead of", [](Bytes& bytes) { bytes.pop_back(); });
        add("half", "instead of", [](Bytes& bytes) { bytes.resize(bytes.size() / 2); });
        add("longer", "instead of", [](Bytes& bytes) { bytes.push_back(std::byte{0}); });
        add("swapped", "checksum", [](Bytes& bytes) {
            std::rotate(bytes.begin() + 400, bytes.begin() + 1400, bytes.end() - 8);
        });
        add("another format",
            "number 9, this version of Sunder reads " + std::to_string(kStateFormat),
            [](Bytes& bytes) { bytes[8] = std::byte{9}; });
        for (const std::size_t at : {std::size_t{12}, std::size_t{25}, std::size_t{60},
                                     good.size() / 2, good.size() - 9, good.size() - 1})
            add("a bit flipped", "checksum", [at](Bytes& bytes) { bytes[at] ^= std::byte{4}; });
        for (const SolverUnderTest& theirs : solversUnderTest())
            if (theirs.name != under.name) {
                const auto other = theirs.make(world);
                cases.push_back(
                    {"another solver", saveState(world, *other),
                     "it is of the solver '" + theirs.name + "', not of '" + under.name + "'"});
            }
        for (const World* other : {&moved, &stronger, &rougher})
            cases.push_back(
                {"another world", saveState(*other, *under.make(*other)), "of another world"});
        for (const Case& c : cases) {
            CAPTURE(c.what);
            try {
                restoreState(world, *solver, c.bytes);
                FAIL("was restored");
            } catch (const InputError& error) {
                const std::string said = error.what();
                CAPTURE(said);
                CHECK(said.find(c.says) != std::string::npos);
                CHECK(said.find('\n') == std::string::npos);
            }
            CHECK(firstDifference(saveState(world, *solver), now) == -1);
        }
        // It would have been restored.
        CHECK(restoreState(world, *solver, good) == 21);
    }
}

TEST_CASE("numbers that no solver saves are refused, whatever the checksum says, or do no harm") {
    const World world(breaking());
    Random random(5);
    for (const SolverUnderTest& under : solversUnderTest()) {
        INFO(under.name);
        IncidentRing ring;
        const auto solver = under.make(world);
        solver->setIncidents(&ring);
        solver->advance(58);
        const Bytes good = saveState(world, *solver);
        solver->advance(5);
        const Bytes now = saveState(world, *solver);
        int refused = 0, restored = 0;
        const int wanted = under.name == "cpu" ? 600 : 120;
        for (int i = 0; i < wanted; ++i) {
            Bytes bytes = good;
            const std::size_t contents = bytes.size() - 48;
            const auto at =
                40 + static_cast<std::size_t>(0.5 * (random() + 1) * static_cast<double>(contents));
            const std::byte values[] = {std::byte{0}, std::byte{0x7f}, std::byte{0x80},
                                        std::byte{0xff}, std::byte{3}};
            // Up to eight bytes in a row: whole numbers become the largest and smallest.
            for (std::size_t k = at; k < std::min(at + 1 + i % 8, bytes.size() - 8); ++k)
                bytes[k] = values[static_cast<std::size_t>(i) % std::size(values)];
            const std::uint64_t checksum = stateChecksum(bytes);
            std::memcpy(bytes.data() + bytes.size() - 8, &checksum, 8);
            CAPTURE(i, at);
            try {
                restoreState(world, *solver, bytes);
                ++restored;
                solver->advance(9);
                solver->finish();
                diagnose(world, solver->state());
                ring.take();
                restoreState(world, *solver, now);
            } catch (const InputError& error) {
                ++refused;
                CHECK(std::string(error.what()).find("cannot be so in this world") !=
                      std::string::npos);
            }
            if (i % 10 == 0) REQUIRE(firstDifference(saveState(world, *solver), now) == -1);
        }
        CHECK(refused > wanted / 20);
        CHECK(restored > wanted / 20);
    }
}
