// The first stage of a search for contacts: where everything is, and what may come near what.
#include <algorithm>
#include <cmath>
#include <limits>

#include "cpu/cpu_contact.hpp"

namespace sunder::cpu {

using namespace core;

namespace {

/// What a sphere may move, in radii, or in searches at its speed, before candidates are renewed.
constexpr float kLeeway = 0.8f;
constexpr float kLeewaySearches = 8;
/// More leeway than this, in radii, would make candidates of everything around.
constexpr float kMostLeeway = 32;
/// Cells of an intact body two or more apart touch only after their displacements differ by as much
/// as lies between them; below this many edges nothing short of crushed cells comes near that.
constexpr float kFold = 2;
constexpr float kFar = std::numeric_limits<float>::max();

// The form that a vector instruction has, which std::min and std::max have not.
void lower(float& bound, float x) {
    bound = x < bound ? x : bound;
}
void raise(float& bound, float x) {
    bound = bound < x ? x : bound;
}

}  // namespace

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
            const float leeway = kLeewaySearches * searchInterval_ * std::sqrt(speed2);
            allowed_[sphere] =
                now.reach + std::clamp(leeway, kLeeway * body.radius, kMostLeeway * body.radius);
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

}  // namespace sunder::cpu
