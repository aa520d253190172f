#include "cpu/cpu_contact.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace sunder::cpu {

using namespace core;

namespace {

constexpr int kTilesPerStretch = 32;

}  // namespace

Contact::Contact(const World& world, std::vector<const BodyArrays*> bodies) : world_(world) {
    step_ = static_cast<float>(world.step());
    closing_ = static_cast<float>(contactMargin(0, 0, 1, world.contactTime()));
    pushSpeed_ = static_cast<float>(world.pushSpeed());
    searchInterval_ = static_cast<float>(world.contactTime());
    sweptSpeed_ = static_cast<float>(kSweptWay / world.step());
    partingTime_ = static_cast<float>(
        std::max(kPartingTime, kInelasticDamping * world.step() / kContactStiffness));
    for (const ElementLaw& law : world.laws()) {
        const Material& m = world.description().materials[law.material];
        laws_.push_back({static_cast<float>(contactProxy(law.cellSize).radius),
                         static_cast<float>(m.density * law.cellSize.prod()),
                         static_cast<float>(law.contactDamping), static_cast<float>(m.friction),
                         static_cast<float>(law.restitution)});
    }
    int first = 0;
    for (const BodyArrays* arrays : bodies) {
        const Body& from = world.bodies()[arrays->index];
        const ContactProxy proxy = contactProxy(from.cellSize);
        BodyContact body{};
        body.arrays = arrays;
        body.first = first;
        body.stride = arrays->vectors * kLanes;
        body.spheres = proxy.spheres();
        body.radius = static_cast<float>(proxy.radius);
        body.edge = static_cast<float>(from.cellSize.minCoeff());
        for (int s = 0; s < body.spheres; ++s)
            for (int corner = 0; corner < kCorners; ++corner)
                body.weight[s][corner] = static_cast<float>(proxy.weights(s)[corner]);
        first += body.stride * body.spheres;
        bodies_.push_back(std::move(body));
    }
    layOut(world);
}

/// Numbers, rest places and materials of the spheres. Absent cells and padding get the place of a
/// present one.
void Contact::layOut(const World& world) {
    const BodyContact& last = bodies_.back();
    const auto count = static_cast<std::size_t>(last.first + last.stride * last.spheres);
    for (auto* fields : {&rest_, &moved_, &velocity_, &before_})
        for (auto& field : *fields) field.assign(count, 0.f);
    allowed_.assign(count, 0.f);
    bodyOf_.assign(count, 0);
    cellOf_.assign(count, 0);
    lawOf_.assign(count, 0);
    there_.assign(count, 0);
    crowd_.assign(count, 0);
    if (wantsFreeMotions()) {
        free_.assign(count, {});
        listed_.assign(count, 0);
    }
    near_.assign(count, {});
    lattice_.assign(count, IVec3::Zero());
    begin_.assign(count + 1, 0);
    for (std::size_t index = 0; index < bodies_.size(); ++index) {
        BodyContact& body = bodies_[index];
        const Body& from = world.bodies()[body.arrays->index];
        int present = 0;
        for (int s = 0; s < body.spheres; ++s) {
            const auto weights = contactProxy(from.cellSize).weights(s);
            for (int i = 0; i < body.stride; ++i) {
                const int sphere = body.first + s * body.stride + i;
                bodyOf_[sphere] = static_cast<int>(index);
                cellOf_[sphere] = body.first + i;
            }
            for (int cell = from.firstCell; cell < from.firstCell + from.cellCount(); ++cell) {
                if (!world.present(cell)) continue;
                const IVec3 c = from.coordinates(cell);
                const int sphere =
                    body.first + s * body.stride + body.arrays->place(c[0], c[1], c[2]);
                Vec3 centre = Vec3::Zero();
                for (int corner = 0; corner < kCorners; ++corner)
                    centre += weights[corner] * world.restPosition(kCorners * cell + corner);
                for (int axis = 0; axis < 3; ++axis)
                    rest_[axis][sphere] = static_cast<float>(centre[axis]);
                lawOf_[sphere] = static_cast<std::uint16_t>(world.lawOf(cell));
                there_[sphere] = 1;
                lattice_[sphere] = c;
                ++present;
            }
        }
        body.present = present == body.stride * body.spheres;
        for (int first = 0; first < body.arrays->vectors; first += kTilesPerStretch)
            stretches_.push_back({static_cast<int>(index),
                                  first,
                                  std::min(first + kTilesPerStretch, body.arrays->vectors),
                                  {},
                                  {},
                                  {},
                                  {},
                                  0,
                                  false});
    }
}

void Contact::search(std::span<const BodyStatus> status, const ForEach& forEach) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        BodyContact& body = bodies_[i];
        body.relink |= due_ || status[i].relinks != body.status.relinks;
        body.status = status[i];
        if (due_) body.inGrid = body.selfInGrid = false;
        if (due_ || body.status.awake) body.settled = false;
    }
    if (due_) candidates_.clear();
    due_ = false;
    forEach(static_cast<int>(bodies_.size()), [&](int i) {
        BodyContact& body = bodies_[i];
        if (body.relink && body.status.held) findLoose(body);
        body.relink = false;
    });
    measureBodies(forEach);
    findNear();
    if (!candidatesHold()) findCandidates(forEach);
    pickPairs(forEach);
    listPairs();
    findIslands();
}

void Contact::rest() {
    active_.clear();
    tiles_.clear();
    islands_.clear();
    for (auto& pairs : picked_) pairs.clear();
    for (BodyContact& body : bodies_) {
        body.touching = body.hit = false;
        body.tiles = body.cells = {};
    }
}

void Contact::archivePair(Archive& a, Pair& pair) const {
    const int count = static_cast<int>(there_.size());
    pair.a = a.whole(pair.a, 0, count - 1);
    pair.b = a.whole(pair.b, pair.a, count - 1);
    a.require(there_[pair.a] && there_[pair.b] && cellOf_[pair.a] != cellOf_[pair.b]);
    const auto bits =
        a.whole<std::uint8_t>(static_cast<std::uint8_t>(pair.neighbours | pair.crowds << 1), 0, 3);
    pair.neighbours = bits & 1;
    pair.crowds = bits >> 1;
}

void Contact::archive(Archive& a, const std::vector<bool>& held, const ForEach& forEach) {
    a.section("contacts");
    const bool due = a.flag(due_);
    std::vector<bool> awake;
    for (const BodyContact& body : bodies_) awake.push_back(a.flag(body.status.awake));
    std::vector<Pair> all;
    if (a.writes()) {
        for (const auto& pairs : picked_) all.insert(all.end(), pairs.begin(), pairs.end());
        // The order they were found in depends on the candidates, and nothing on it.
        std::sort(all.begin(), all.end(), [](const Pair& first, const Pair& second) {
            return std::pair(first.a, first.b) < std::pair(second.a, second.b);
        });
    }
    const auto most = std::numeric_limits<int>::max() / 4;  // two entries for each
    a.list(all, static_cast<std::size_t>(most), [&](Pair& pair) {
        archivePair(a, pair);
        const int bodyA = bodyOf_[pair.a], bodyB = bodyOf_[pair.b];
        a.require(due || (held[bodyA] && held[bodyB] && (awake[bodyA] || awake[bodyB])));
    });
    if (!a.reads()) return;
    due_ = due;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        BodyContact& body = bodies_[i];
        body.status = {held[i], awake[i], 0};
        body.relink = true;
        body.settled = body.inGrid = body.selfInGrid = false;
    }
    candidates_.clear();
    picked_.assign(1, std::move(all));
    measureBodies(forEach);
    listPairs();
    findIslands();
}

/// Centres and velocities of a tile's spheres of one number.
void Contact::centreTile(const BodyContact& body, int tile, int sphere) {
    const int at = body.first + sphere * body.stride + tile * kLanes;
    for (int axis = 0; axis < 3; ++axis) {
        const std::ptrdiff_t tiles = tiled(kNodeComponents, axis, tile * kLanes);
        const float* u = body.arrays->displacement + tiles;
        const float* v = body.arrays->velocity + tiles;
        float sumU[kLanes] = {}, sumV[kLanes] = {};
        for (int corner = 0; corner < kCorners; ++corner) {
            const float weight = body.weight[sphere][corner];
            for (int lane = 0; lane < kLanes; ++lane) {
                sumU[lane] += weight * u[3 * corner * kLanes + lane];
                sumV[lane] += weight * v[3 * corner * kLanes + lane];
            }
        }
        std::copy_n(sumU, kLanes, moved_[axis].data() + at);
        std::copy_n(sumV, kLanes, velocity_[axis].data() + at);
    }
}

/// The part of a range whose entries, ascending by `key`, have first <= key < end.
template <class Entry>
Contact::Range Contact::within(const std::vector<Entry>& entries, Range all, int Entry::*key,
                               int first, int end) {
    const auto find = [&](int bound) {
        const auto at =
            std::partition_point(entries.begin() + all.from, entries.begin() + all.to,
                                 [&](const Entry& entry) { return entry.*key < bound; });
        return static_cast<int>(at - entries.begin());
    };
    return {find(first), find(end)};
}

Contact::Range Contact::tilesOf(int body, int first, int end) const {
    return within(tiles_, tilesOf(body), &ActiveTile::tile, first, end);
}

Contact::Range Contact::cellsOf(int body, int first, int end) const {
    return within(active_, cellsOf(body), &ActiveCell::cell, first * kLanes, end * kLanes);
}

/// Centres and velocities of the spheres.
void Contact::follow(Range tiles) {
    for (int i = tiles.from; i < tiles.to; ++i) {
        const BodyContact& body = bodies_[tiles_[i].body];
        for (int s = 0; s < body.spheres; ++s) centreTile(body, tiles_[i].tile, s);
    }
}

float Contact::touchTime(const std::array<float, 3>& x, const std::array<float, 3>& v,
                         float radii) const {
    constexpr float never = std::numeric_limits<float>::infinity();
    const float apart = distance2(x) - radii * radii;
    if (apart < 0) return 0;
    const float along = dot(x, v), squared = distance2(v), fast = sweptSpeed_ * radii;
    if (!(along < 0 && squared > fast * fast)) return never;
    const float root = along * along - squared * apart;
    if (!(root >= 0)) return never;
    const float time = apart / (std::sqrt(root) - along);
    return time <= step_ ? time : never;
}

/// Whether the spheres surely do not touch in the step.
bool Contact::apart(int sphere, int other) const {
    std::array<float, 3> way, closing;
    for (int axis = 0; axis < 3; ++axis) {
        way[axis] = (rest_[axis][sphere] - rest_[axis][other]) +
                    (moved_[axis][sphere] - moved_[axis][other]);
        closing[axis] = velocity_[axis][sphere] - velocity_[axis][other];
    }
    return touchTime(way, closing, laws_[lawOf_[sphere]].radius + laws_[lawOf_[other]].radius) >
           step_;
}

const Parting* Contact::partingOf(int sphere, int other) const {
    if (world_.partings().empty() || bodyOf_[sphere] == bodyOf_[other]) return nullptr;
    return world_.parting(bodies_[bodyOf_[sphere]].arrays->index,
                          bodies_[bodyOf_[other]].arrays->index);
}

/// Force on `a`, which is less than `b`.
std::array<float, 3> Contact::pairForce(int a, int b, bool neighbours) const {
    const CellLaw &lawA = laws_[lawOf_[a]], &lawB = laws_[lawOf_[b]];
    std::array<float, 3> normal, v;
    for (int axis = 0; axis < 3; ++axis) {
        normal[axis] = (rest_[axis][a] - rest_[axis][b]) + (moved_[axis][a] - moved_[axis][b]);
        v[axis] = velocity_[axis][a] - velocity_[axis][b];
    }
    const float touch = lawA.radius + lawB.radius, time = touchTime(normal, v, touch);
    if (!(time <= step_)) return {0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) normal[axis] += time * v[axis];
    const float distance = std::sqrt(distance2(normal));
    const float overlap = time > 0 ? 0 : touch - distance;
    if (distance > 0)
        for (float& x : normal) x /= distance;
    else
        normal = {0, 1, 0};
    const Parting* parting = partingOf(a, b);
    if (parting && parting->lasts({moved_[0][a] - moved_[0][b], moved_[1][a] - moved_[1][b],
                                   moved_[2][a] - moved_[2][b]}))
        for (int axis = 0; axis < 3; ++axis) normal[axis] = static_cast<float>(parting->way[axis]);
    const auto crowd = static_cast<float>(std::max({1, crowd_[cellOf_[a]], crowd_[cellOf_[b]]}));
    std::array<float, 3> hold{0, 0, 0};
    const float rate = lawA.mass * lawB.mass / ((lawA.mass + lawB.mass) * step_ * crowd);
    const float approach = dot(v, normal), fast = sweptSpeed_ * touch;
    float push = 0;
    if (neighbours) {
        push = static_cast<float>(kInelasticDamping) * rate * (overlap / partingTime_ - approach);
    } else {
        push = rate * (static_cast<float>(kContactStiffness) / step_ * overlap -
                       0.5f * (lawA.damping + lawB.damping) *
                           std::clamp(approach, -overlap / step_, overlap / step_));
        if (distance2(v) > fast * fast)
            push = std::max(push,
                            -(1 + 0.5f * (lawA.restitution + lawB.restitution)) * rate * approach);
    }
    if (!free_.empty() && !neighbours && time == 0) {
        hold = stopOf(a, b);
        for (float& x : hold) x /= crowd;
        const float along = dot(hold, normal);
        push = std::max(0.f, push) + static_cast<float>(kConstraintShare) * along;
        for (int axis = 0; axis < 3; ++axis) hold[axis] -= along * normal[axis];
    }
    if (parting)
        push =
            std::min(push, static_cast<float>(kInelasticDamping) * rate * (pushSpeed_ - approach));
    push = std::max(0.f, push);
    std::array<float, 3> drag;
    for (int axis = 0; axis < 3; ++axis)
        drag[axis] = hold[axis] -
                     static_cast<float>(kFrictionRate) * rate * (v[axis] - approach * normal[axis]);
    const float size = std::sqrt(distance2(drag));
    const float most = 0.5f * (lawA.friction + lawB.friction) * push;
    const float share = size > most ? most / size : 1;
    return {push * normal[0] + share * drag[0], push * normal[1] + share * drag[1],
            push * normal[2] + share * drag[2]};
}

std::array<float, 3> Contact::stopOf(int a, int b) const {
    const FreeMotion &freeA = free_[a], &freeB = free_[b];
    const float inverse = freeA.inverseContact + freeB.inverseContact;
    const float mass = inverse > 0 ? 1 / inverse : 0;  // 0: neither can move
    std::array<float, 3> stop;
    for (int axis = 0; axis < 3; ++axis)
        stop[axis] = mass * (freeB.acceleration[axis] - freeA.acceleration[axis]);
    return stop;
}

void Contact::findFreeMotions(Range cells) {
    for (int i = cells.from; i < cells.to; ++i) {
        const BodyContact& body = bodies_[active_[i].body];
        const BodyArrays& a = *body.arrays;
        const int cell = active_[i].cell;
        FreeMotion corners[kCorners];
        for (int corner = 0; corner < kCorners; ++corner) {
            const std::ptrdiff_t at = tiled(kCorners, corner, cell);
            const float inverseMass = a.inverseMass[at];
            if (inverseMass == 0) continue;
            std::array<float, 3> force{0, 0, 0};
            int listed = 0;
            for (int m = 0; m < a.memberCount; ++m) {
                const auto& [bit, offset] = a.members[corner][m];
                if (!(a.links[at] & bit)) continue;
                for (int axis = 0; axis < 3; ++axis)
                    force[axis] += a.force[cell + offset + axis * a.stride];
                const int memberCorner = std::countr_zero(bit) ^ 7;
                listed += listed_[body.first + cell + offset - 3 * memberCorner * a.stride];
            }
            for (int axis = 0; axis < 3; ++axis)
                corners[corner].acceleration[axis] = force[axis] * inverseMass + a.gravity[axis];
            corners[corner].inverseContact = static_cast<float>(listed) * inverseMass / kCorners;
        }
        for (int s = 0; s < body.spheres; ++s) {
            FreeMotion& free = free_[body.first + s * body.stride + cell];
            free = {};
            for (int corner = 0; corner < kCorners; ++corner) {
                for (int axis = 0; axis < 3; ++axis)
                    free.acceleration[axis] +=
                        body.weight[s][corner] * corners[corner].acceleration[axis];
                free.inverseContact += body.weight[s][corner] * corners[corner].inverseContact;
            }
        }
    }
}

/// Adds the forces on the cells to those on their corners.
void Contact::push(Range cells) {
    for (int i = cells.from; i < cells.to; ++i) {
        const BodyContact& body = bodies_[active_[i].body];
        float* force = body.arrays->force + active_[i].cell;
        for (int s = 0; s < body.spheres; ++s) {
            const int sphere = body.first + s * body.stride + active_[i].cell;
            std::array<float, 3> sum{0, 0, 0};
            bool pushed = false;
            float total = 0, hardest = 0;  // N
            int by = -1;
            for (int entry = begin_[sphere]; entry < begin_[sphere + 1]; ++entry) {
                const int other = partner_[entry] / 2;
                if (apart(sphere, other)) continue;
                const bool first = sphere < other;
                const auto f =
                    pairForce(first ? sphere : other, first ? other : sphere, partner_[entry] & 1);
                for (int axis = 0; axis < 3; ++axis) sum[axis] += first ? f[axis] : -f[axis];
                pushed = true;
                if (!watch_) continue;
                const float size = std::sqrt(distance2(f));
                total += size;
                if (size <= hardest) continue;
                hardest = size;
                by = other;
            }
            if (!pushed) continue;
            if (hardest > 0)
                watch_->push(worldCell(sphere), total * step_, hardest * step_, worldCell(by), -1);
            for (int corner = 0; corner < kCorners; ++corner)
                for (int axis = 0; axis < 3; ++axis)
                    force[(3 * corner + axis) * body.arrays->stride] +=
                        body.weight[s][corner] * sum[axis];
        }
    }
}

std::size_t Contact::bytes() const {
    std::size_t sum = grid_.bytes() +
                      rest_[0].size() * (12 * sizeof(float) + sizeof(float) + 4 * sizeof(int) + 3);
    sum += (candidates_.capacity() * sizeof(ContactGrid::Candidate)) +
           partner_.capacity() * sizeof(int) + active_.capacity() * sizeof(ActiveCell);
    for (const auto& pairs : picked_) sum += pairs.capacity() * sizeof(Pair);
    for (const BodyContact& body : bodies_)
        sum += sizeof body + body.loose.capacity() * sizeof(BodyContact::Loose);
    return sum;
}

}  // namespace sunder::cpu
