#include "cpu/cpu_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/sleep.hpp"

namespace sunder::cpu {
namespace {

constexpr int kTilesPerStretch = 32;
constexpr int kCandidatesPerPart = 4096;
/// What a sphere may move, in radii, or in searches at its speed, before candidates are renewed.
constexpr float kLeeway = 0.4f;
constexpr float kLeewaySearches = 8;
/// Cells of an intact body two or more apart touch only after their displacements differ by as much
/// as lies between them; below this many edges nothing short of crushed cells comes near that.
constexpr float kFold = 2;
constexpr float kFar = std::numeric_limits<float>::max();

void lower(float& bound, float x) {
    bound = x < bound ? x : bound;
}
void raise(float& bound, float x) {
    bound = bound < x ? x : bound;
}

float distance2(const std::array<float, 3>& a) {
    return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
}

}  // namespace

Contact::Contact(const World& world, std::vector<const BodyArrays*> bodies) {
    step_ = static_cast<float>(world.step());
    closing_ = static_cast<float>(contactMargin(0, 0, 1, world.step()));
    partingTime_ = static_cast<float>(
        std::max(kPartingTime, kInelasticDamping * world.step() / kContactStiffness));
    for (const ElementLaw& law : world.laws()) {
        const Material& m = world.description().materials[law.material];
        laws_.push_back({static_cast<float>(contactProxy(law.cellSize).radius),
                         static_cast<float>(m.density * law.cellSize.prod()),
                         static_cast<float>(law.contactDamping), static_cast<float>(m.friction)});
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
        body.relink = true;
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

/// A tile's spheres, their bounds, and whether one of them has used up the way that candidates
/// allow it.
void Contact::measureTile(const BodyContact& body, int tile, Bounds& bounds) {
    for (int s = 0; s < body.spheres; ++s) {
        const int at = body.first + s * body.stride + tile * kLanes;
        centreTile(body, tile, s);
        float square[kLanes] = {}, way[kLanes] = {}, place[3][kLanes], reach[kLanes];
        for (int axis = 0; axis < 3; ++axis) {
            const float* moved = moved_[axis].data() + at;
            const float* velocity = velocity_[axis].data() + at;
            const float* before = before_[axis].data() + at;
            const float* rest = rest_[axis].data() + at;
            for (int lane = 0; lane < kLanes; ++lane) {
                square[lane] += velocity[lane] * velocity[lane];
                const float since = moved[lane] - before[lane];
                way[lane] += since * since;
                place[axis][lane] = rest[lane] + moved[lane];
            }
        }
        const float* allowed = allowed_.data() + at;
        float used[kLanes];
        for (int lane = 0; lane < kLanes; ++lane) {
            const float closing = closing_ * std::sqrt(square[lane]), half = 0.5f * body.radius;
            reach[lane] = body.radius + (half < closing ? closing : half);
            used[lane] = std::sqrt(way[lane]) + reach[lane] - allowed[lane];
        }
        for (int lane = 0; lane < kLanes; ++lane)
            near_[at + lane] = {place[0][lane], place[1][lane], place[2][lane], reach[lane]};
        for (int lane = 0; lane < kLanes; ++lane) {
            if (body.present || there_[at + lane]) continue;
            used[lane] = -1;
            reach[lane] = 0;
            for (int axis = 0; axis < 3; ++axis) place[axis][lane] = kFar;
        }
        for (int axis = 0; axis < 3; ++axis) {
            const float* moved = moved_[axis].data() + at;
            for (int lane = 0; lane < kLanes; ++lane) {
                const float x = place[axis][lane], u = moved[lane];
                const bool there = x != kFar;
                lower(bounds.low[axis][lane], there ? x : kFar);
                raise(bounds.high[axis][lane], there ? x : -kFar);
                lower(bounds.lowU[axis][lane], there ? u : kFar);
                raise(bounds.highU[axis][lane], there ? u : -kFar);
            }
        }
        for (int lane = 0; lane < kLanes; ++lane) {
            raise(bounds.reach[lane], reach[lane]);
            raise(bounds.used[lane], used[lane]);
        }
    }
}

void Contact::measure(Stretch& stretch) {
    const BodyContact& body = bodies_[stretch.body];
    if (!body.status.held || body.settled) return;
    Bounds bounds;
    for (int axis = 0; axis < 3; ++axis) {
        std::fill_n(bounds.low[axis], kLanes, kFar);
        std::fill_n(bounds.lowU[axis], kLanes, kFar);
        std::fill_n(bounds.high[axis], kLanes, -kFar);
        std::fill_n(bounds.highU[axis], kLanes, -kFar);
    }
    std::fill_n(bounds.reach, kLanes, 0.f);
    std::fill_n(bounds.used, kLanes, -1.f);
    for (int tile = stretch.first; tile < stretch.end; ++tile) measureTile(body, tile, bounds);
    for (int axis = 0; axis < 3; ++axis) {
        stretch.low[axis] = *std::min_element(bounds.low[axis], bounds.low[axis] + kLanes);
        stretch.lowU[axis] = *std::min_element(bounds.lowU[axis], bounds.lowU[axis] + kLanes);
        stretch.high[axis] = *std::max_element(bounds.high[axis], bounds.high[axis] + kLanes);
        stretch.highU[axis] = *std::max_element(bounds.highU[axis], bounds.highU[axis] + kLanes);
    }
    stretch.reach = *std::max_element(bounds.reach, bounds.reach + kLanes);
    stretch.expired = *std::max_element(bounds.used, bounds.used + kLanes) > 0;
}

void Contact::measureBodies(const ForEach& forEach) {
    forEach(static_cast<int>(stretches_.size()), [&](int i) { measure(stretches_[i]); });
    for (std::size_t i = 0; i < stretches_.size();) {
        BodyContact& body = bodies_[stretches_[i].body];
        std::array<float, 3> lowU = stretches_[i].lowU, highU = stretches_[i].highU;
        body.low = stretches_[i].low;
        body.high = stretches_[i].high;
        float reach = 0;
        const int index = stretches_[i].body;
        for (; i < stretches_.size() && stretches_[i].body == index; ++i) {
            const Stretch& part = stretches_[i];
            reach = std::max(reach, part.reach);
            for (int axis = 0; axis < 3; ++axis) {
                body.low[axis] = std::min(body.low[axis], part.low[axis]);
                body.high[axis] = std::max(body.high[axis], part.high[axis]);
                lowU[axis] = std::min(lowU[axis], part.lowU[axis]);
                highU[axis] = std::max(highU[axis], part.highU[axis]);
            }
        }
        for (int axis = 0; axis < 3; ++axis) {
            body.low[axis] -= reach;
            body.high[axis] += reach;
        }
        body.spread =
            std::sqrt(distance2({highU[0] - lowU[0], highU[1] - lowU[1], highU[2] - lowU[2]}));
        body.settled = !body.status.awake;
    }
}

/// Lattice neighbours that share no joined node. Each pair once: the second cell comes later.
void Contact::findLoose(BodyContact& body) const {
    const BodyArrays& a = *body.arrays;
    body.loose.clear();
    const auto octantOf = [](int corner, const int* apart) {
        int octant = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const int side = (~corner >> axis & 1) + apart[axis];
            if (side < 0 || side > 1) return -1;
            octant |= side << axis;
        }
        return octant;
    };
    for (int n = 14; n < 27; ++n) {
        const int apart[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
        int corners[4], bits[4], count = 0;
        for (int corner = 0; corner < kCorners; ++corner)
            if (const int octant = octantOf(corner, apart); octant >= 0) {
                corners[count] = corner;
                bits[count++] = octant;
            }
        const int offset = a.place(apart[0], apart[1], apart[2]);
        for (int z = 0; z + apart[2] < a.extent[2]; ++z)
            for (int y = std::max(0, -apart[1]); y < a.extent[1] - std::max(0, apart[1]); ++y)
                for (int x = std::max(0, -apart[0]); x < a.extent[0] - std::max(0, apart[0]); ++x) {
                    const int cell = a.place(x, y, z);
                    if (!there_[body.first + cell] || !there_[body.first + cell + offset]) continue;
                    bool joined = false;
                    for (int i = 0; i < count; ++i)
                        joined |= a.links[tiled(kCorners, corners[i], cell)] >> bits[i] & 1;
                    if (!joined) body.loose.push_back({cell, cell + offset});
                }
    }
    body.broken = !body.loose.empty();
}

/// Which bodies may have pairs now: those whose own cells may touch, and those near another one; at
/// least one of the two is awake.
void Contact::findNear() {
    std::vector<int> order;
    for (int i = 0; i < static_cast<int>(bodies_.size()); ++i) {
        BodyContact& body = bodies_[i];
        body.self = body.status.held && body.status.awake &&
                    (body.broken || !(body.spread < kFold * body.edge));
        body.near = body.self;
        if (body.status.held) order.push_back(i);
    }
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return std::pair(bodies_[a].low[0], a) < std::pair(bodies_[b].low[0], b);
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        BodyContact& a = bodies_[order[i]];
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            BodyContact& b = bodies_[order[j]];
            if (b.low[0] > a.high[0]) break;
            if (a.near && b.near) continue;
            if (!a.status.awake && !b.status.awake) continue;
            if (a.low[1] > b.high[1] || b.low[1] > a.high[1] || a.low[2] > b.high[2] ||
                b.low[2] > a.high[2])
                continue;
            a.near = b.near = true;
        }
    }
}

/// Whether the list of candidates still has every pair that may be near.
bool Contact::candidatesHold() const {
    for (const BodyContact& body : bodies_)
        if ((body.near && !body.inGrid) || (body.self && !body.selfInGrid)) return false;
    for (const Stretch& stretch : stretches_)
        if (bodies_[stretch.body].near && stretch.expired) return false;
    return true;
}

void Contact::findCandidates(const ForEach& forEach) {
    grid_.clear();
    for (BodyContact& body : bodies_) {
        body.inGrid = body.near;
        body.selfInGrid = body.self;
        if (!body.near) continue;
        for (int sphere = body.first; sphere < body.first + body.stride * body.spheres; ++sphere) {
            if (!there_[sphere]) continue;
            const Near& now = near_[sphere];
            float speed2 = 0;
            for (int axis = 0; axis < 3; ++axis) {
                before_[axis][sphere] = moved_[axis][sphere];
                speed2 += velocity_[axis][sphere] * velocity_[axis][sphere];
            }
            const float leeway = kLeewaySearches * kContactInterval * step_ * std::sqrt(speed2);
            allowed_[sphere] = now.reach + std::max(kLeeway * body.radius, leeway);
            grid_.add({now.x, now.y, now.z, allowed_[sphere], sphere});
        }
    }
    for (Stretch& stretch : stretches_) stretch.expired = false;
    const int parts = grid_.prepare();
    std::vector<std::vector<ContactGrid::Candidate>> found(static_cast<std::size_t>(parts));
    const auto wanted = [&](int a, int b) {
        if (bodyOf_[a] != bodyOf_[b]) return true;
        const BodyContact& body = bodies_[bodyOf_[a]];
        if (!body.self || cellOf_[a] == cellOf_[b]) return false;
        // Lattice neighbours have a list of their own.
        const IVec3 &p = lattice_[a], &q = lattice_[b];
        return std::abs(p[0] - q[0]) > 1 || std::abs(p[1] - q[1]) > 1 || std::abs(p[2] - q[2]) > 1;
    };
    forEach(parts, [&](int part) { grid_.find(part, wanted, found[part]); });
    candidates_.clear();
    for (const auto& part : found) candidates_.insert(candidates_.end(), part.begin(), part.end());
}

/// Takes the pair if its spheres' gap is less than contactMargin().
void Contact::pick(int a, int b, bool neighbours, std::vector<Pair>& pairs) const {
    // Rounding of places is far below a thousandth of the radii that reaches consist of.
    const Near &p = near_[a], &q = near_[b];
    const float x = p.x - q.x, y = p.y - q.y, z = p.z - q.z, r = 1.001f * (p.reach + q.reach);
    if (x * x + y * y + z * z > r * r) return;
    if (a > b) std::swap(a, b);
    const BodyContact &bodyA = bodies_[bodyOf_[a]], &bodyB = bodies_[bodyOf_[b]];
    if (!bodyA.status.awake && !bodyB.status.awake) return;
    std::array<float, 3> apart, closing;
    for (int axis = 0; axis < 3; ++axis) {
        apart[axis] = (rest_[axis][a] - rest_[axis][b]) + (moved_[axis][a] - moved_[axis][b]);
        closing[axis] = velocity_[axis][a] - velocity_[axis][b];
    }
    const float ra = laws_[lawOf_[a]].radius, rb = laws_[lawOf_[b]].radius, touch = ra + rb;
    const float margin = std::max(0.5f * touch, closing_ * std::sqrt(distance2(closing)));
    const float far2 = distance2(apart);
    if (!(far2 < (touch + margin) * (touch + margin))) return;
    const float crowded = touch + static_cast<float>(kCrowdGap) * std::min(ra, rb);
    Pair pair{a, b, neighbours, far2 < crowded * crowded, false, false};
    if (far2 < touch * touch && bodyOf_[a] != bodyOf_[b]) {
        const auto fast = [&](int sphere, const BodyContact& body) {
            const float creep = static_cast<float>(kCreepSpeed) * body.edge;
            return distance2({velocity_[0][sphere], velocity_[1][sphere], velocity_[2][sphere]}) >
                   creep * creep;
        };
        pair.hitsA = !bodyA.status.awake && fast(b, bodyB);
        pair.hitsB = !bodyB.status.awake && fast(a, bodyA);
    }
    pairs.push_back(pair);
}

void Contact::pickPairs(const ForEach& forEach) {
    struct Part {
        const BodyContact* body;  ///< loose neighbours of a body, or candidates
        std::size_t from, to;
    };
    std::vector<Part> parts;
    const auto cut = [&](const BodyContact* body, std::size_t count) {
        for (std::size_t from = 0; from < count; from += kCandidatesPerPart)
            parts.push_back({body, from, std::min(count, from + kCandidatesPerPart)});
    };
    for (const BodyContact& body : bodies_)
        if (body.self) cut(&body, body.loose.size());
    cut(nullptr, candidates_.size());
    picked_.resize(parts.size());
    forEach(static_cast<int>(parts.size()), [&](int index) {
        const Part& part = parts[index];
        std::vector<Pair>& pairs = picked_[index];
        pairs.clear();
        for (std::size_t i = part.from; i < part.to; ++i) {
            if (!part.body) {
                pick(candidates_[i].a, candidates_[i].b, false, pairs);
                continue;
            }
            const BodyContact& body = *part.body;
            const auto [a, b] = body.loose[i];
            for (int s = 0; s < body.spheres; ++s)
                for (int t = 0; t < body.spheres; ++t)
                    pick(body.first + s * body.stride + a, body.first + t * body.stride + b, true,
                         pairs);
        }
    });
}

/// Counts crowds, and gives every sphere of an awake body its partners, in ascending order.
void Contact::listPairs() {
    std::fill(crowd_.begin(), crowd_.end(), 0);
    std::fill(begin_.begin(), begin_.end(), 0);
    for (BodyContact& body : bodies_) body.touching = body.hit = false;
    const auto awake = [&](int sphere) { return bodies_[bodyOf_[sphere]].status.awake; };
    for (const auto& pairs : picked_)
        for (const Pair& pair : pairs) {
            crowd_[cellOf_[pair.a]] += pair.crowds;
            crowd_[cellOf_[pair.b]] += pair.crowds;
            begin_[pair.a + 1] += awake(pair.a);
            begin_[pair.b + 1] += awake(pair.b);
            bodies_[bodyOf_[pair.a]].hit |= pair.hitsA;
            bodies_[bodyOf_[pair.b]].hit |= pair.hitsB;
        }
    listActive();
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    partner_.resize(static_cast<std::size_t>(begin_.back()));
    // Fills each sphere's entries from their end, in order.
    const auto enter = [&](int sphere, int other, bool neighbours) {
        if (!awake(sphere)) return;
        partner_[--begin_[sphere + 1]] = 2 * other + neighbours;
    };
    for (const auto& pairs : picked_)
        for (const Pair& pair : pairs) {
            enter(pair.a, pair.b, pair.neighbours);
            enter(pair.b, pair.a, pair.neighbours);
        }
    // begin_[s + 1] is now where sphere s begins; shift back.
    begin_.erase(begin_.begin());
    begin_.push_back(static_cast<int>(partner_.size()));
    for (const ActiveCell& active : active_) {
        const BodyContact& body = bodies_[active.body];
        for (int s = 0; s < body.spheres; ++s) {
            const int sphere = body.first + s * body.stride + active.cell;
            std::sort(partner_.begin() + begin_[sphere], partner_.begin() + begin_[sphere + 1]);
        }
    }
}

/// Cells with partners, and the tiles they are in; begin_ holds counts, one place on.
void Contact::listActive() {
    active_.clear();
    tiles_.clear();
    for (std::size_t index = 0; index < bodies_.size(); ++index) {
        BodyContact& body = bodies_[index];
        body.tiles.from = static_cast<int>(tiles_.size());
        body.cells.from = static_cast<int>(active_.size());
        for (int cell = 0; cell < body.stride; ++cell) {
            int entries = 0;
            for (int s = 0; s < body.spheres; ++s)
                entries += begin_[body.first + s * body.stride + cell + 1];
            if (entries == 0) continue;
            active_.push_back({static_cast<int>(index), cell});
            if (!body.touching || tiles_.back().tile != cell / kLanes)
                tiles_.push_back({static_cast<int>(index), cell / kLanes});
            body.touching = true;
        }
        body.tiles.to = static_cast<int>(tiles_.size());
        body.cells.to = static_cast<int>(active_.size());
    }
}

/// Union–find over pairs of awake bodies; the root of an island is its first body.
void Contact::findIslands() {
    for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].island = static_cast<int>(i);
    const auto root = [&](int body) {
        while (bodies_[body].island != body)
            body = bodies_[body].island = bodies_[bodies_[body].island].island;
        return body;
    };
    for (const auto& pairs : picked_)
        for (const Pair& pair : pairs) {
            const int a = bodyOf_[pair.a], b = bodyOf_[pair.b];
            if (a == b || !bodies_[a].status.awake || !bodies_[b].status.awake) continue;
            const int rootA = root(a), rootB = root(b);
            bodies_[std::max(rootA, rootB)].island = std::min(rootA, rootB);
        }
    islands_.clear();
    std::vector<int> place(bodies_.size(), -1);
    for (int i = 0; i < static_cast<int>(bodies_.size()); ++i) {
        if (!bodies_[i].touching) continue;
        int& at = place[root(i)];
        if (at < 0) {
            at = static_cast<int>(islands_.size());
            islands_.emplace_back();
        }
        islands_[at].push_back(i);
    }
}

void Contact::rest() {
    active_.clear();
    tiles_.clear();
    islands_.clear();
    for (BodyContact& body : bodies_) body.touching = body.hit = false;
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

/// Centres and velocities of the spheres.
void Contact::follow(Range tiles) {
    for (int i = tiles.from; i < tiles.to; ++i) {
        const BodyContact& body = bodies_[tiles_[i].body];
        for (int s = 0; s < body.spheres; ++s) centreTile(body, tiles_[i].tile, s);
    }
}

/// Whether the spheres surely do not touch.
bool Contact::apart(int sphere, int other) const {
    std::array<float, 3> way;
    for (int axis = 0; axis < 3; ++axis)
        way[axis] = (rest_[axis][sphere] - rest_[axis][other]) +
                    (moved_[axis][sphere] - moved_[axis][other]);
    const float touch = laws_[lawOf_[sphere]].radius + laws_[lawOf_[other]].radius;
    return distance2(way) >= touch * touch;
}

/// Force on `a`, which is less than `b`.
std::array<float, 3> Contact::pairForce(int a, int b, bool neighbours) const {
    const CellLaw &lawA = laws_[lawOf_[a]], &lawB = laws_[lawOf_[b]];
    std::array<float, 3> normal, v;
    for (int axis = 0; axis < 3; ++axis) {
        normal[axis] = (rest_[axis][a] - rest_[axis][b]) + (moved_[axis][a] - moved_[axis][b]);
        v[axis] = velocity_[axis][a] - velocity_[axis][b];
    }
    const float touch = lawA.radius + lawB.radius, squared = distance2(normal);
    if (!(squared < touch * touch)) return {0, 0, 0};
    const float distance = std::sqrt(squared), overlap = touch - distance;
    if (distance > 0)
        for (float& x : normal) x /= distance;
    else
        normal = {0, 1, 0};
    const auto crowd = static_cast<float>(std::max({1, crowd_[cellOf_[a]], crowd_[cellOf_[b]]}));
    const float rate = lawA.mass * lawB.mass / ((lawA.mass + lawB.mass) * step_ * crowd);
    const float approach = v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
    float push = 0;
    if (neighbours)
        push = static_cast<float>(kInelasticDamping) * rate * (overlap / partingTime_ - approach);
    else
        push = rate * (static_cast<float>(kContactStiffness) / step_ * overlap -
                       0.5f * (lawA.damping + lawB.damping) *
                           std::clamp(approach, -overlap / step_, overlap / step_));
    push = std::max(0.f, push);
    std::array<float, 3> slip;
    for (int axis = 0; axis < 3; ++axis) slip[axis] = v[axis] - approach * normal[axis];
    const float speed = std::sqrt(distance2(slip));
    const float drag = std::min(0.5f * (lawA.friction + lawB.friction) * push,
                                static_cast<float>(kFrictionRate) * rate * speed);
    const float share = speed > 0 ? drag / speed : 0;
    return {push * normal[0] - share * slip[0], push * normal[1] - share * slip[1],
            push * normal[2] - share * slip[2]};
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
            for (int entry = begin_[sphere]; entry < begin_[sphere + 1]; ++entry) {
                const int other = partner_[entry] / 2;
                if (apart(sphere, other)) continue;
                const bool first = sphere < other;
                const auto f =
                    pairForce(first ? sphere : other, first ? other : sphere, partner_[entry] & 1);
                for (int axis = 0; axis < 3; ++axis) sum[axis] += first ? f[axis] : -f[axis];
                pushed = true;
            }
            if (!pushed) continue;
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
