// The second stage of a search for contacts: pairs, crowds, partners, islands.
#include <algorithm>
#include <cmath>

#include "core/sleep.hpp"
#include "cpu/cpu_contact.hpp"

namespace sunder::cpu {

using namespace core;

namespace {

constexpr int kCandidatesPerPart = 4096;

/// m², the square of closestApproach() (core/contact.hpp).
float closestApproach2(const std::array<float, 3>& x, const std::array<float, 3>& v, float time) {
    const float squared = distance2(v);
    const float when = squared > 0 ? std::clamp(-dot(x, v) / squared, 0.f, time) : 0;
    return distance2({x[0] + when * v[0], x[1] + when * v[1], x[2] + when * v[2]});
}

}  // namespace

/// Takes the pair if its spheres' gap is less than contactMargin().
void Contact::pick(int a, int b, bool neighbours, std::vector<Pair>& pairs) const {
    // Rounding of places is far below a thousandth of the radii that reaches consist of.
    const Near &p = near_[a], &q = near_[b];
    const float x = p.x - q.x, y = p.y - q.y, z = p.z - q.z, r = 1.001f * (p.reach + q.reach);
    if (x * x + y * y + z * z > r * r) return;
    if (a > b) std::swap(a, b);
    const BodyContact &bodyA = bodies_[bodyOf_[a]], &bodyB = bodies_[bodyOf_[b]];
    if (!bodyA.status.awake && !bodyB.status.awake) return;
    // Candidates may be from when the body's cells could touch each other.
    if (!neighbours && bodyOf_[a] == bodyOf_[b] && !bodyA.self) return;
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
    const float near2 = closestApproach2(apart, closing, searchInterval_);
    Pair pair{a, b, neighbours, near2 < crowded * crowded, false, false};
    if (near2 < touch * touch && bodyOf_[a] != bodyOf_[b]) {
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
    std::fill(free_.begin(), free_.end(), FreeMotion{});
    std::fill(listed_.begin(), listed_.end(), std::uint8_t{0});
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
            if (!listed_.empty()) listed_[body.first + cell] = 1;
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

}  // namespace sunder::cpu
