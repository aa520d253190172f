#include "cpu/reference_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/archive.hpp"

namespace sunder::cpu {

using namespace core;

ReferenceContact::ReferenceContact(const World& world) : world_(world) {
    for (const Body& body : world.bodies()) {
        const ContactProxy& proxy = proxies_.emplace_back(contactProxy(body.cellSize));
        auto& weights = weights_.emplace_back();
        for (int number = 0; number < proxy.spheres(); ++number)
            weights.push_back(proxy.weights(number));
    }
    crowd_.resize(static_cast<std::size_t>(world.cellCount()));
}

ReferenceContact::Sphere ReferenceContact::sphere(const State& state, int cell, int number) const {
    Sphere sphere{cell, number, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), 0};
    const auto& weights = weights_[world_.bodyOf(cell)][number];
    for (int corner = 0; corner < kCorners; ++corner) {
        const int node = kCorners * cell + corner;
        sphere.centre += weights[corner] * (world_.restPosition(node) + state.displacement[node]);
        sphere.moved += weights[corner] * state.displacement[node];
        sphere.velocity += weights[corner] * state.velocity[node];
    }
    // Two spheres' margin is at most the sum of what each would have against its like at rest.
    const double radius = proxyOf(cell).radius;
    sphere.reach = radius + contactMargin(radius, 0, sphere.velocity.norm(), world_.contactTime());
    return sphere;
}

bool ReferenceContact::neighbours(int cellA, int cellB) const {
    if (world_.bodyOf(cellA) != world_.bodyOf(cellB)) return false;
    const Body& body = world_.bodies()[world_.bodyOf(cellA)];
    const IVec3 apart = body.coordinates(cellA) - body.coordinates(cellB);
    return apart.cwiseAbs().maxCoeff() <= 1;
}

/// Whether two lattice neighbours share a joined node.
bool ReferenceContact::joined(int cellA, int cellB, const std::vector<std::uint8_t>& links) const {
    const Body& body = world_.bodies()[world_.bodyOf(cellA)];
    const IVec3 apart = body.coordinates(cellB) - body.coordinates(cellA);
    for (int corner = 0; corner < kCorners; ++corner) {
        IVec3
            octant;  // of B around the lattice point, per axis; outside 0..1 where it is not there
        for (int axis = 0; axis < 3; ++axis) octant[axis] = (~corner >> axis & 1) + apart[axis];
        if (octant.minCoeff() < 0 || octant.maxCoeff() > 1) continue;
        const int bit = octant[0] | octant[1] << 1 | octant[2] << 2;
        if (links[kCorners * cellA + corner] >> bit & 1) return true;
    }
    return false;
}

/// Sweep along x.
void ReferenceContact::search(const State& state, const std::vector<std::uint8_t>& links) {
    std::vector<Sphere> spheres;
    for (int cell = 0; cell < world_.cellCount(); ++cell)
        if (world_.present(cell, state))
            for (int number = 0; number < proxyOf(cell).spheres(); ++number)
                spheres.push_back(sphere(state, cell, number));
    const auto low = [](const Sphere& s) { return s.centre[0] - s.reach; };
    std::sort(spheres.begin(), spheres.end(),
              [&](const Sphere& a, const Sphere& b) { return low(a) < low(b); });
    pairs_.clear();
    std::fill(crowd_.begin(), crowd_.end(), 0);
    for (std::size_t i = 0; i < spheres.size(); ++i)
        for (std::size_t j = i + 1;
             j < spheres.size() && low(spheres[j]) < spheres[i].centre[0] + spheres[i].reach; ++j) {
            const bool ordered = spheres[i].cell < spheres[j].cell;
            const Sphere &a = spheres[ordered ? i : j], &b = spheres[ordered ? j : i];
            if (a.cell == b.cell) continue;
            const double ra = proxyOf(a.cell).radius, rb = proxyOf(b.cell).radius;
            const double gap = (a.centre - b.centre).norm() - ra - rb;
            const double speed = (a.velocity - b.velocity).norm();
            if (!(gap < contactMargin(ra, rb, speed, world_.contactTime()))) continue;
            const bool near = neighbours(a.cell, b.cell);
            if (near && joined(a.cell, b.cell, links)) continue;
            pairs_.push_back({a.cell, a.number, b.cell, b.number, near});
            const double nearest = closestApproach(a.centre - b.centre, a.velocity - b.velocity,
                                                   world_.contactTime()) -
                                   ra - rb;
            if (nearest < kCrowdGap * std::min(ra, rb)) {
                ++crowd_[a.cell];
                ++crowd_[b.cell];
            }
        }
    std::sort(pairs_.begin(), pairs_.end());
    listCells();
}

void ReferenceContact::listCells() {
    listed_.assign(static_cast<std::size_t>(world_.cellCount()), false);
    for (const Pair& pair : pairs_) listed_[pair.cellA] = listed_[pair.cellB] = true;
}

void ReferenceContact::archive(Archive& a) {
    a.section("contacts");
    const auto sphere = [&](int& cell, int& number) {
        cell = a.whole(cell, 0, world_.cellCount() - 1);
        a.require(world_.present(cell));
        number = a.whole(number, 0, proxyOf(cell).spheres() - 1);
    };
    std::vector<Pair> pairs = pairs_;
    a.list(pairs, std::numeric_limits<int>::max(), [&](Pair& pair) {
        sphere(pair.cellA, pair.sphereA);
        sphere(pair.cellB, pair.sphereB);
        a.require(pair.cellA < pair.cellB);
        pair.neighbours = a.flag(pair.neighbours);
    });
    std::vector<int> crowd = crowd_;
    for (int& count : crowd) count = a.whole(count, 0, 1 << 30);
    if (!a.reads()) return;
    pairs_ = std::move(pairs);
    crowd_ = std::move(crowd);
    listCells();
}

ReferenceContact::FreeSphere ReferenceContact::freeSphere(int cell, int number,
                                                          const std::vector<FreeNode>& free) const {
    const auto& weights = weights_[world_.bodyOf(cell)][number];
    FreeSphere sphere;
    for (int corner = 0; corner < kCorners; ++corner) {
        const FreeNode& node = free[kCorners * cell + corner];
        sphere.acceleration += weights[corner] * node.acceleration;
        sphere.inverseContact += weights[corner] * node.inverseContact;
    }
    return sphere;
}

Vec3 ReferenceContact::pairForce(const Pair& pair, const State& state,
                                 const std::vector<FreeNode>& free) const {
    const Sphere a = sphere(state, pair.cellA, pair.sphereA);
    const Sphere b = sphere(state, pair.cellB, pair.sphereB);
    const Vec3 v = a.velocity - b.velocity;
    const double h = world_.step();
    const double radii = proxyOf(a.cell).radius + proxyOf(b.cell).radius;
    const double time = touchTime(a.centre - b.centre, v, radii, h);
    if (!(time <= h)) return Vec3::Zero();
    const Vec3 apart = a.centre - b.centre + time * v;
    const double distance = apart.norm();
    const double overlap = time > 0 ? 0 : radii - distance;
    const Parting* parting = world_.parting(world_.bodyOf(a.cell), world_.bodyOf(b.cell));
    Vec3 normal = distance > 0 ? Vec3(apart / distance) : Vec3(0, 1, 0);
    if (parting && parting->lasts(a.moved - b.moved)) normal = parting->way;
    const double ma = world_.cellMass(a.cell), mb = world_.cellMass(b.cell);
    const double crowd = std::max({1, crowd_[a.cell], crowd_[b.cell]});
    const double rate = ma * mb / (ma + mb) / h / crowd;
    const double approach = v.dot(normal);
    double push = 0;
    if (pair.neighbours) {
        const double wait = std::max(kPartingTime, kInelasticDamping * h / kContactStiffness);
        push = kInelasticDamping * rate * (overlap / wait - approach);
    } else {
        const double damping = 0.5 * (dampingOf(a.cell) + dampingOf(b.cell));
        // w·(v·n): the share of the step in touch, for it is δ/h that they came closer in touch.
        push = rate * (kContactStiffness * overlap / h -
                       damping * std::clamp(approach, -overlap / h, overlap / h));
        if (h * v.norm() > kSweptWay * radii)
            push = std::max(push, -(1 + restitution(a.cell, b.cell)) * rate * approach);
    }
    Vec3 hold = Vec3::Zero();
    if (!free.empty() && !pair.neighbours && time == 0) {
        Vec3 stop = Vec3::Zero();
        const FreeSphere freeA = freeSphere(pair.cellA, pair.sphereA, free);
        const FreeSphere freeB = freeSphere(pair.cellB, pair.sphereB, free);
        const double inverse = freeA.inverseContact + freeB.inverseContact;
        if (inverse > 0)  // or neither can move
            stop = (freeB.acceleration - freeA.acceleration) / inverse / crowd;
        push = std::max(0.0, push) + kConstraintShare * stop.dot(normal);
        hold = stop - stop.dot(normal) * normal;
    }
    if (parting) push = std::min(push, kInelasticDamping * rate * (world_.pushSpeed() - approach));
    push = std::max(0.0, push);
    const Vec3 slip = v - approach * normal;
    const double friction =
        0.5 * (world_.materialOf(a.cell).friction + world_.materialOf(b.cell).friction);
    const Vec3 drag = hold - kFrictionRate * rate * slip;
    const double size = drag.norm(), most = friction * push;
    return push * normal + (size > most ? most / size : 1) * drag;
}

void ReferenceContact::addToCorners(int cell, int number, const Vec3& force,
                                    std::vector<Vec3>& nodes) const {
    const auto& weights = weights_[world_.bodyOf(cell)][number];
    for (int corner = 0; corner < kCorners; ++corner)
        nodes[kCorners * cell + corner] += weights[corner] * force;
}

void ReferenceContact::addForces(const State& state, const std::vector<FreeNode>& free,
                                 std::vector<Vec3>& force, IncidentWatch* watch) const {
    for (const Pair& pair : pairs_) {
        const Vec3 onA = pairForce(pair, state, free);
        addToCorners(pair.cellA, pair.sphereA, onA, force);
        addToCorners(pair.cellB, pair.sphereB, -onA, force);
        if (!watch) continue;
        const double impulse = onA.norm() * world_.step();
        watch->push(pair.cellA, impulse, impulse, pair.cellB, -1);
        watch->push(pair.cellB, impulse, impulse, pair.cellA, -1);
    }
}

}  // namespace sunder::cpu
