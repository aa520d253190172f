#include "core/world.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/check.hpp"
#include "core/contact.hpp"
#include "core/elasticity.hpp"
#include "core/memory.hpp"
#include "core/orientation.hpp"
#include "core/strength_map.hpp"
#include "core/wording.hpp"

namespace sunder::core {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Axis 0..2 and end (0: low, 1: high) of a side.
struct SidePlace {
    int axis, end;
};
SidePlace place(Side side) {
    return {static_cast<int>(side) / 2, static_cast<int>(side) % 2};
}

/// Rounded to single precision, by way of memory: where GCC 12 makes vectors of double → float →
/// double (-O2), it leaves the rounding out.
double inSingle(double x) {
    const volatile float single = static_cast<float>(x);
    return single;
}

/// A time that is meant to be a whole number of steps is one, however it was rounded.
double inSteps(double time, double step) {
    const double steps = time / step, whole = std::round(steps);
    return std::abs(steps - whole) <= 1e-12 * std::max(1.0, steps) ? whole : steps;
}

/// In a list of bodies that ascends, once.
void include(std::vector<int>& bodies, int body) {
    const auto at = std::lower_bound(bodies.begin(), bodies.end(), body);
    if (at == bodies.end() || *at != body) bodies.insert(at, body);
}

}  // namespace

IVec3 Body::coordinates(int cell) const {
    const int local = cell - firstCell;
    return {local % cells[0], local / cells[0] % cells[1], local / (cells[0] * cells[1])};
}

bool Body::contains(const IVec3& c) const {
    return (c.array() >= 0).all() && (c.array() < cells.array()).all();
}

Box Body::bounds() const {
    if (!turned) return {origin, origin + size()};
    const Vec3 centre = inWorld(0.5 * size()), reach = axes.cwiseAbs() * (0.5 * size());
    return {centre - reach, centre + reach};
}

World::World(WorldDescription description) : description_(std::move(description)) {
    check(description_);
    layOutCells();
    findOverlaps();
    layOutNodes();
    makeBonds();
    findIntervals();
    makeEvents();
    makeObjects();
    findUnequalCells();
    fingerprint_ = findFingerprint();
}

const Material& World::materialOf(int cell) const {
    return description_.materials[laws_[cellLaw_[cell]].material];
}

const Parting* World::parting(int bodyA, int bodyB) const {
    const std::pair wanted(std::min(bodyA, bodyB), std::max(bodyA, bodyB));
    const auto key = [](const Parting& parting) { return std::pair(parting.a, parting.b); };
    const auto found = std::lower_bound(
        partings_.begin(), partings_.end(), wanted,
        [&](const Parting& parting, const auto& pair) { return key(parting) < pair; });
    return found != partings_.end() && key(*found) == wanted ? &*found : nullptr;
}

std::uint64_t World::bodySeed(int body) const {
    return description_.seed * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(body);
}

int World::parity(int cell) const {
    return bodies_[cellBody_[cell]].coordinates(cell).sum() & 1;
}

int World::neighbour(int cell, int axis, int direction) const {
    const Body& body = bodies_[cellBody_[cell]];
    IVec3 c = body.coordinates(cell);
    c[axis] += direction;
    if (!body.contains(c)) return -1;
    const int other = body.cellAt(c);
    return present(other) ? other : -1;
}

Vec3 World::restPosition(int node) const {
    const int cell = node / kCorners, corner = node % kCorners;
    const Body& body = bodies_[cellBody_[cell]];
    const IVec3 point = body.coordinates(cell) + IVec3(corner & 1, corner >> 1 & 1, corner >> 2);
    return body.inWorld(point.cast<double>().cwiseProduct(body.cellSize)).unaryExpr(&inSingle);
}

Vec3 World::cornerOffset(int cell, int corner) const {
    return Vec3(corner & 1, corner >> 1 & 1, corner >> 2)
        .cwiseProduct(bodies_[cellBody_[cell]].cellSize);
}

int World::lawFor(int materialIndex, const Vec3& cellSize) {
    for (std::size_t i = 0; i < laws_.size(); ++i)
        if (laws_[i].material == materialIndex && laws_[i].cellSize == cellSize)
            return static_cast<int>(i);
    assert(laws_.size() < kMaxElementLaws);  // check() counts them
    const Material& m = description_.materials[materialIndex];
    ElementLaw law;
    law.material = materialIndex;
    law.cellSize = cellSize;
    const double stable =
        stableYoungModulus(m.density, cellSize.minCoeff(), m.poissonRatio, description_.step);
    law.limited = m.youngModulus > stable;
    law.youngModulus = std::min(m.youngModulus, stable);
    const double E = law.youngModulus, nu = m.poissonRatio;
    law.lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
    law.mu = E / (2 * (1 + nu));
    law.stressScale = std::sqrt(m.youngModulus / E);
    law.hotViscosity = hotViscosity(law.mu, stable / E, description_.step);
    law.largestStress = largestGreenStress(m.density, cellSize.minCoeff(), description_.step);
    law.damageTime = m.damageLength / std::sqrt(E / m.density);
    law.suddenTraction = law.limited ? kSuddenStrain * E : kInfinity;
    law.maxStress = m.fracture == FractureMode::Cell ? m.maxStress : kInfinity;
    law.restitution = std::round(255 * m.restitution) / 255;
    law.contactDamping = contactDamping(m.restitution);
    laws_.push_back(law);
    return static_cast<int>(laws_.size()) - 1;
}

void World::findIntervals() {
    const double step = description_.step;
    constexpr double rounding = 1e-6;  // of quotients that are whole numbers
    contactInterval_ =
        kContactSteps *
        std::max(1, static_cast<int>(kContactTime / (kContactSteps * step) + rounding));
    fractureInterval_ = description_.fractureInterval;
    if (fractureInterval_ > 0) return;
    double most = kInfinity;  // of the steps that a material would carry
    for (const ElementLaw& law : laws_) {
        const Material& m = description_.materials[law.material];
        if (m.fracture == FractureMode::None) continue;
        const double stable =
            stableYoungModulus(m.density, law.cellSize.minCoeff(), m.poissonRatio, step);
        most = std::min(most, std::sqrt(stable / law.youngModulus));
    }
    const int searches = std::min(contactInterval_ / kLookSteps, 25);
    fractureInterval_ =
        kLookSteps * static_cast<int>(std::clamp<double>(most + rounding, 1, searches));
}

void World::layOutCells() {
    std::int64_t total = 0;
    for (const BodyDescription& body : description_.bodies) total += cellsOf(body.cells);
    requireMemory(total);
    cellBody_.reserve(total);
    cellLaw_.reserve(total);
    for (std::size_t index = 0; index < description_.bodies.size(); ++index) {
        const BodyDescription& from = description_.bodies[index];
        Body body;
        body.name = from.name;
        body.cells = from.cells;
        body.cellSize = from.size.cwiseQuotient(from.cells.cast<double>());
        body.origin = originOf(from);
        body.axes = axesOf(from.orientation);
        body.turned = !isUpright(body.axes);
        body.firstCell = static_cast<int>(cellBody_.size());
        const auto base = static_cast<std::int16_t>(lawFor(from.material, body.cellSize));
        cellBody_.resize(body.firstCell + body.cellCount(), static_cast<int>(index));
        cellLaw_.resize(body.firstCell + body.cellCount(), base);
        for (const RegionDescription& region : from.regions) {
            const auto law = static_cast<std::int16_t>(
                region.material < 0 ? -1 : lawFor(region.material, body.cellSize));
            for (int z = region.from[2]; z <= region.to[2]; ++z)
                for (int y = region.from[1]; y <= region.to[1]; ++y)
                    for (int x = region.from[0]; x <= region.to[0]; ++x)
                        cellLaw_[body.cellAt({x, y, z})] = law;
        }
        // A cell's mass follows from its density alone: all cells of a body have one size.
        double density = 0, drag = 0, gravity = 0;
        int present = 0;
        for (int cell = body.firstCell; cell < body.firstCell + body.cellCount(); ++cell) {
            if (cellLaw_[cell] < 0) continue;
            const Material& m = description_.materials[laws_[cellLaw_[cell]].material];
            ++present;
            density += m.density;
            drag += m.density * m.damping;
            gravity += m.density * m.gravity;
        }
        if (present == 0)
            throw InputError(called("body", body.name, index) +
                             " has no cells left: its regions remove them all");
        body.drag = drag / density;
        body.gravity = description_.gravity * (gravity / density);
        presentCells_ += present;
        bodies_.push_back(std::move(body));
    }
}

void World::findOverlaps() {
    partings_ = startOverlaps(description_).partings;
    // Nothing falls asleep on its way out.
    const double calmest = pushSpeed() / 4;
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (description_.bodies[i].mayOverlap) bodies_[i].calmest = calmest;
    for (const Parting& parting : partings_)
        bodies_[parting.a].calmest = bodies_[parting.b].calmest = calmest;
}

void World::findUnequalCells() {
    double lightest = kInfinity, heaviest = 0;
    for (int cell = 0; cell < cellCount(); ++cell) {
        if (!present(cell)) continue;
        lightest = std::min(lightest, cellMass(cell));
        heaviest = std::max(heaviest, cellMass(cell));
    }
    unequalCells_ = description_.contact && heaviest > kUnequal * lightest;
}

void World::layOutNodes() {
    nodeMass_.assign(nodeCount(), 0);
    anchored_.assign(nodeCount(), 0);
    for (int cell = 0; cell < cellCount(); ++cell) {
        if (!present(cell)) continue;
        const Body& body = bodies_[cellBody_[cell]];
        // Lumped mass: an eighth of the cell at each corner, the mean of the two mirrored splits. A
        // quarter of each tetrahedron at each of its corners would put 1/24 and 5/24 on alternate
        // corners, and raise the highest frequency of a free cell, which limits the step, by up to
        // a third.
        const double cornerMass = materialOf(cell).density * body.cellSize.prod() / kCorners;
        std::fill_n(nodeMass_.begin() + kCorners * cell, kCorners, cornerMass);
        const IVec3 c = body.coordinates(cell);
        for (const Side side : description_.bodies[cellBody_[cell]].anchors) {
            const auto [axis, end] = place(side);
            if (c[axis] != (end ? body.cells[axis] - 1 : 0)) continue;
            for (int corner = 0; corner < kCorners; ++corner)
                if ((corner >> axis & 1) == end) anchored_[kCorners * cell + corner] = 1;
        }
    }
}

void World::makeBonds() {
    bondStrength_.assign(bondSlots(), std::numeric_limits<float>::infinity());
    for (int cell = 0; cell < cellCount(); ++cell) {
        if (!present(cell)) continue;
        const int bodyIndex = cellBody_[cell];
        const Body& body = bodies_[bodyIndex];
        const std::uint64_t seed = bodySeed(bodyIndex);
        const Vec3 centre =
            (body.coordinates(cell).cast<double>() + Vec3(.5, .5, .5)).cwiseProduct(body.cellSize);
        for (int axis = 0; axis < 3; ++axis) {
            const int other = neighbour(cell, axis, +1);
            if (other < 0) continue;
            ++bondCount_;
            Vec3 otherCentre = centre;
            otherCentre[axis] += body.cellSize[axis];
            const std::uint64_t bond =
                kBondsPerCell * static_cast<std::uint64_t>(cell - body.firstCell) + axis;
            double strength = kInfinity;
            // Where two materials meet, the weaker one gives way.
            for (const int side : {cell, other})
                if (materialOf(side).fracture == FractureMode::Bond)
                    strength = std::min(
                        strength, sunder::core::bondStrength(materialOf(side), centre, otherCentre,
                                                             axis, bond, seed));
            bondStrength_[kBondsPerCell * cell + axis] = static_cast<float>(strength);
        }
    }
}

void World::makeEvents() {
    std::vector<std::size_t> sorted(description_.events.size());
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    std::stable_sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) {
        return description_.events[a].body < description_.events[b].body;
    });
    for (const std::size_t index : sorted) {
        const EventDescription& from = description_.events[index];
        events_.push_back(
            layOutEvent(from, from.where.empty() ? called("event", {}, index) : from.where));
    }
}

Event World::makeEvent(EventDescription event, double now, bool released) const {
    const std::string name = event.where.empty() ? "the event" : event.where;
    checkEvent(event, bodies_.size(), complainAbout(name));
    event.time += now;
    return layOutEvent(event, name, released);
}

ObjectState World::makeThrow(const ThrowDescription& thrown) const {
    checkThrow(thrown, description_.objects, complainAbout("the throw"));
    return thrownState(description_.objects[thrown.object], thrown);
}

Event World::layOutEvent(const EventDescription& from, const std::string& name,
                         bool released) const {
    Event event;
    event.body = from.body;
    event.radius = static_cast<float>(from.radius);
    event.start = inSteps(from.time, step());
    event.end = inSteps(from.time + from.duration, step());
    if (from.body == kEveryBody) {
        event.point = from.point.cast<float>();
        event.acceleration = from.vector / from.duration;
        event.outward = from.outward / from.duration;
        event.falloff = from.falloff;
        return event;
    }
    const Body& body = bodies_[from.body];
    event.point = (description_.bodies[from.body].position + body.axes * from.point).cast<float>();
    double mass = 0;
    for (int node = kCorners * body.firstCell;
         node < kCorners * (body.firstCell + body.cellCount()); ++node) {
        if ((released || !anchored(node)) && insidePatch(event, restPosition(node).cast<float>()))
            mass += nodeMass(node);
    }
    if (mass == 0)
        throw InputError(name + ": no free node of " +
                         called("body", body.name, static_cast<std::size_t>(from.body)) +
                         " lies within radius of point; move the point onto the body or raise the "
                         "radius");
    switch (from.kind) {
        case EventDescription::Kind::Impulse:
            event.acceleration = from.vector / (mass * from.duration);
            break;
        case EventDescription::Kind::Force:
            event.acceleration = from.vector / mass;
            break;
        case EventDescription::Kind::Velocity:
            event.acceleration = from.vector / from.duration;
            break;
    }
    return event;
}

void World::makeObjects() {
    for (const ObjectDescription& from : description_.objects) objects_.push_back(makeObject(from));
    for (const ThrowDescription& from : description_.throws) {
        const auto at = static_cast<std::int64_t>(std::ceil(from.time / step() - 1e-6));
        throws_.push_back({at, from.object, thrownState(description_.objects[from.object], from)});
    }
    std::stable_sort(throws_.begin(), throws_.end(),
                     [](const Throw& a, const Throw& b) { return a.step < b.step; });
}

bool World::anyTurned() const {
    return std::any_of(bodies_.begin(), bodies_.end(),
                       [](const Body& body) { return body.turned; });
}

bool World::bondsBreak() const {
    return std::any_of(bondStrength_.begin(), bondStrength_.end(),
                       [](float strength) { return std::isfinite(strength); });
}

bool World::cellsBreak() const {
    return std::any_of(laws_.begin(), laws_.end(),
                       [](const ElementLaw& law) { return std::isfinite(law.maxStress); });
}

State World::initialState() const {
    State state;
    state.displacement.assign(nodeCount(), Vec3::Zero());
    state.velocity.assign(nodeCount(), Vec3::Zero());
    state.damage.assign(bondSlots(), kNoBond);
    state.slow.assign(bondSlots(), 0);
    state.slowStress.assign(cellCount(), 0);
    for (int cell = 0; cell < cellCount(); ++cell) {
        if (!present(cell)) continue;
        for (int axis = 0; axis < 3; ++axis)
            if (neighbour(cell, axis, +1) >= 0) state.damage[kBondsPerCell * cell + axis] = 0;
    }
    for (const ObjectDescription& object : description_.objects)
        state.objects.push_back(sunder::core::initialState(object));
    for (int body = 0; body < static_cast<int>(bodies_.size()); ++body)
        if (!description_.bodies[body].present) state.absent.push_back(body);
    return state;
}

void World::setPresent(State& state, int body, bool present) const {
    if (present)
        std::erase(state.absent, body);
    else
        include(state.absent, body);
    std::erase(state.released, body);
    copyBody(initialState(), body, state);
}

void World::copyBody(const State& from, int body, State& to) const {
    const Body& of = bodies_[body];
    const auto copy = [&](const auto& source, auto& target, int each) {
        std::copy_n(source.begin() + each * of.firstCell, each * of.cellCount(),
                    target.begin() + each * of.firstCell);
    };
    copy(from.displacement, to.displacement, kCorners);
    copy(from.velocity, to.velocity, kCorners);
    copy(from.damage, to.damage, kBondsPerCell);
    copy(from.slow, to.slow, kBondsPerCell);
    copy(from.slowStress, to.slowStress, 1);
}

void World::releaseAnchors(State& state, int body) const {
    if (state.has(body) && !description_.bodies[body].anchors.empty())
        include(state.released, body);
}

}  // namespace sunder::core
