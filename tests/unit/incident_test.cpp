// Incidents (core/incident.hpp): the ring, impulses.
#include "core/incident.hpp"

#include "catch.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

Incident numbered(int cell) {
    Incident incident;
    incident.cell = cell;
    return incident;
}

std::vector<int> cellsOf(const std::vector<Incident>& incidents) {
    std::vector<int> cells;
    for (const Incident& incident : incidents) cells.push_back(incident.cell);
    return cells;
}

}  // namespace

TEST_CASE("a ring hands over every incident once, in order") {
    IncidentRing ring(4);
    CHECK(ring.capacity() == 4);
    CHECK(ring.take().empty());
    for (int i = 0; i < 3; ++i) ring.push(numbered(i));
    CHECK(cellsOf(ring.take()) == std::vector{0, 1, 2});
    CHECK(ring.take().empty());
    for (int i = 3; i < 7; ++i) ring.push(numbered(i));
    CHECK(cellsOf(ring.take()) == std::vector{3, 4, 5, 6});
    CHECK(ring.dropped() == 0);
}

TEST_CASE("a full ring keeps the newest and counts what it drops") {
    IncidentRing ring(4);
    for (int i = 0; i < 11; ++i) ring.push(numbered(i));
    CHECK(ring.dropped() == 7);
    ring.drop(5);
    CHECK(ring.dropped() == 12);
    CHECK(cellsOf(ring.take()) == std::vector{7, 8, 9, 10});
    ring.push(numbered(11));
    CHECK(cellsOf(ring.take()) == std::vector{11});
    CHECK(ring.dropped() == 12);
}

TEST_CASE("a blow that two looks share counts once, a lasting load not at all") {
    CHECK(blow(5, 0, 0) == 5);
    CHECK(blow(2, 5, 0) == 2);  // the rest of it
    CHECK(blow(3, 3, 3) == 0);
    CHECK(blow(7, 3, 3) == 4);
    CHECK(blow(3, 7, 3) == 0);
}

TEST_CASE("a break's impulse is its strength times area times fracture interval") {
    WorldDescription d = block({2, 1, 1}, brittle());
    d.materials[0].spread = 0;
    d.bodies[0].size = {0.2, 0.3, 0.1};
    d.fractureInterval = 3;
    const World world(d);
    const Incident incident = breakOf(world, 0, 100);
    CHECK(incident.kind == Incident::Kind::Break);
    CHECK(incident.step == 100);
    CHECK(incident.cell == 0);
    CHECK(incident.other == 1);
    CHECK(incident.impulse == Approx(double{world.bondStrength(0)} * 0.03 * 3 / 3000));
    CHECK(materialsOf(world, incident) == std::vector<std::string>{"soft", "soft"});

    d.materials[0].fracture = FractureMode::Cell;
    d.materials[0].maxStress = 5e4;
    CHECK(breakOf(World(d), 0, 0).impulse == Approx(5e4 * 0.03 * 3 / 3000));
}
