#include "core/overlap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "core/box_gap.hpp"
#include "core/contact.hpp"
#include "core/description.hpp"
#include "core/orientation.hpp"
#include "core/room.hpp"
#include "core/wording.hpp"

namespace sunder::core {
namespace {

std::string metres(double x) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), std::abs(x) < 1000 ? "%.3g m" : "%.0f m", x);
    return text.data();
}

/// Which cells of a body there are, x fastest.
class Presence {
  public:
    explicit Presence(const BodyDescription& body)
        : cells_(body.cells), there_(static_cast<std::size_t>(body.cells.prod()), true) {
        for (const RegionDescription& region : body.regions)
            forEach(region.from, region.to, [&](std::size_t cell) {
                there_[cell] = region.material >= 0;
                return true;
            });
    }

    bool operator()(const IVec3& cell) const { return there_[number(cell)]; }
    bool all(const IVec3& from, const IVec3& to) const {
        return forEach(from, to, [&](std::size_t cell) { return there_[cell] != 0; });
    }
    void remove(const IVec3& from, const IVec3& to) {
        forEach(from, to, [&](std::size_t cell) {
            there_[cell] = false;
            return true;
        });
    }

  private:
    std::size_t number(const IVec3& c) const {
        return static_cast<std::size_t>(c[0] + cells_[0] * (c[1] + cells_[1] * c[2]));
    }
    /// Until `work` returns false, and then that.
    template <class Work>
    bool forEach(const IVec3& from, const IVec3& to, const Work& work) const {
        for (int z = from[2]; z <= to[2]; ++z)
            for (int y = from[1]; y <= to[1]; ++y)
                for (int x = from[0]; x <= to[0]; ++x)
                    if (!work(number({x, y, z}))) return false;
        return true;
    }

    IVec3 cells_;
    std::vector<std::uint8_t> there_;
};

/// What takes part: a body or an object that is there as the world begins.
struct Thing {
    std::string name;   ///< "body 'wall'"
    std::string where;  ///< "walls.toml:31: body 1: position"
    bool mayOverlap, fixed;
    double edge;  ///< m, the shortest of its cells, or its own
    Box around;
    int body = -1, object = -1;  ///< one of them
};

/// One of the boxes that things consist of.
struct Part {
    int thing;
    RoundedBox box;
};

Box around(const RoundedBox& box) {
    const Vec3 reach = box.axes.cwiseAbs() * box.half + Vec3::Constant(box.radius);
    return {box.centre - reach, box.centre + reach};
}

/// With sharp edges.
RoundedBox whole(const RoundedBox& box) {
    return {box.centre, box.axes, box.half + Vec3::Constant(box.radius), 0};
}

/// Along axes: by how much a would have to move to lie just below b, and just above.
void spread(const Mat3& axes, const RoundedBox& a, const RoundedBox& b, Vec3& low, Vec3& high) {
    const auto reach = [&](const RoundedBox& box) -> Vec3 {
        return (axes.transpose() * box.axes).cwiseAbs() * whole(box).half;
    };
    const Vec3 apart = axes.transpose() * (b.centre - a.centre), reaches = reach(a) + reach(b);
    low = apart - reaches;
    high = apart + reaches;
}

/// m: the shortest way out.
double depthOf(const Parting& parting) {
    return std::min(parting.high.minCoeff(), (-parting.low).minCoeff());
}

Vec3 shortestWay(const Parting& parting) {
    int up = 0, down = 0;
    const double high = parting.high.minCoeff(&up), low = (-parting.low).minCoeff(&down);
    return high <= low ? Vec3(parting.axes.col(up)) : Vec3(-parting.axes.col(down));
}

class Check {
  public:
    explicit Check(const WorldDescription& world) : world_(world) {
        for (const BodyDescription& body : world.bodies) add(body);
        for (std::size_t i = 0; i < world.objects.size(); ++i)
            if (world.objects[i].position) add(world.objects[i], i);
    }

    StartOverlaps result() {
        checkBarriers();
        StartOverlaps result;
        if (world_.contact)
            result.compared = forEachOverlap(boxes_, [&](int a, int b) { check(a, b); });
        for (const auto& [bodies, parting] : partings_) result.partings.push_back(parting);
        return result;
    }

  private:
    void add(const BodyDescription& body) {
        Thing thing{
            called("body", body.name, things_.size()), body.where, body.mayOverlap, false, 0, {}};
        thing.body = static_cast<int>(things_.size());
        thing.edge = body.size.cwiseQuotient(body.cells.cast<double>()).minCoeff();
        const double radius = kCellRoundness * thing.edge;
        const Mat3 axes = axesOf(body.orientation);
        for (const Box& box : boxesOf(body)) {
            const Vec3 half = 0.5 * (box.high - box.low) - Vec3::Constant(radius);
            if (isUpright(axes)) {
                addPart(thing, box, {box.centre(), axes, half, radius});
                continue;
            }
            const Vec3 centre = body.position + axes * (box.centre() - body.position);
            const RoundedBox turned{centre, axes, half, radius};
            addPart(thing, around(whole(turned)), turned);
        }
        things_.push_back(std::move(thing));
    }

    void add(const ObjectDescription& object, std::size_t index) {
        Thing thing{called("object", object.name, index),
                    object.where,
                    object.mayOverlap,
                    object.unyielding(),
                    2 * object.halfSize.minCoeff(),
                    {}};
        thing.object = static_cast<int>(things_.size());
        const RoundedBox box = boxOf(makeObject(object), initialState(object));
        addPart(thing, around(box), box);
        things_.push_back(std::move(thing));
    }

    void addPart(Thing& thing, const Box& bounds, const RoundedBox& box) {
        const int number = static_cast<int>(things_.size());
        if (parts_.empty() || parts_.back().thing != number) thing.around = bounds;
        thing.around.include(bounds);
        parts_.push_back({number, box});
        boxes_.push_back(bounds);
    }

    /// m, of what lies there, in single precision.
    static double rounding(const Box& box) {
        return 0x1p-22 * std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
    }

    void checkBarriers() const {
        for (const Thing& thing : things_) {
            if (thing.mayOverlap || thing.fixed) continue;
            for (const Barrier& barrier : barriers(world_)) {
                const Vec3& end = barrier.side > 0 ? thing.around.low : thing.around.high;
                const double depth = -barrier.distance(end);
                if (depth > kOverlapShare * thing.edge + rounding(thing.around))
                    refuse(thing, barrier, depth);
            }
        }
    }

    [[noreturn]] void refuse(const Thing& thing, const Barrier& barrier, double depth) const {
        const bool floor = barrier.axis == 1 && barrier.side > 0,
                   ceiling = barrier.axis == 1 && !floor;
        const std::string what = floor ? " below the ground at y = 0"
                                 : ceiling
                                     ? " above the room's ceiling at " + metres(barrier.place)
                                     : std::string(" beyond the room's wall at ") +
                                           "xyz"[barrier.axis] + " = " + metres(barrier.place);
        fail(thing, thing.name + " reaches " + metres(depth) + what +
                        " when the world begins; move it, or give it overlap = \"allow\" to have "
                        "it pushed back gently");
    }

    [[noreturn]] static void fail(const Thing& thing, const std::string& problem) {
        throw InputError((thing.where.empty() ? "" : thing.where + ": ") + problem);
    }

    /// a < b, so the first thing comes before the second, too.
    void check(int a, int b) {
        const Part &first = parts_[a], &second = parts_[b];
        const Thing &one = things_[first.thing], &other = things_[second.thing];
        const bool bodies = one.body >= 0 && other.body >= 0,
                   may = one.mayOverlap || other.mayOverlap;
        // Objects are parted whether they are known to overlap or not.
        if (first.thing == second.thing || (one.fixed && other.fixed) || (may && !bodies)) return;
        const double depth = bodies ? partingOf(a, b).second : -gapBetween(first.box, second.box);
        double tolerance = kOverlapShare * std::min(one.edge, other.edge);
        if (bodies)
            tolerance = std::min(tolerance,
                                 world_.partingSpeed * world_.step / std::sqrt(kContactStiffness));
        if (depth <= tolerance + rounding(boxes_[a]) + rounding(boxes_[b])) return;
        if (may) return part(a, b);
        fail(other, other.name + " and " + one.name + " overlap by " + metres(depth) +
                        " when the world begins; move one of them, or give one overlap = "
                        "\"allow\" to have them parted gently");
    }

    /// Of two boxes of bodies, and how deep they are in each other.
    std::pair<Parting, double> partingOf(int i, int j) const {
        Parting parting{parts_[i].thing, parts_[j].thing, boxes_[j].low - boxes_[i].high,
                        boxes_[j].high - boxes_[i].low};
        const RoundedBox &a = parts_[i].box, &b = parts_[j].box;
        const bool upright = isUpright(a.axes) && isUpright(b.axes);
        if (!upright) {
            parting = alongAxes(a.axes, i, j);
            const Parting other = alongAxes(b.axes, i, j);
            if (depthOf(other) < depthOf(parting)) parting = other;
        }
        parting.way = shortestWay(parting);
        // An edge that lies across another comes out of it sooner than along anybody's axes.
        return {parting, upright ? depthOf(parting) : -gapBetween(whole(a), whole(b))};
    }

    Parting alongAxes(const Mat3& axes, int i, int j) const {
        Parting parting{parts_[i].thing, parts_[j].thing};
        parting.axes = axes;
        spread(axes, parts_[i].box, parts_[j].box, parting.low, parting.high);
        return parting;
    }

    /// Notes the deepest overlap of two bodies.
    void part(int i, int j) {
        const auto [parting, depth] = partingOf(i, j);
        const auto [known, fresh] = partings_.try_emplace({parting.a, parting.b}, parting);
        if (fresh && partings_.size() > kMaxPartings)
            throw InputError("more than " + std::to_string(kMaxPartings) +
                             " pairs of bodies overlap when the world begins; use fewer bodies "
                             "with overlap = \"allow\"");
        if (depth > depthOf(known->second)) known->second = parting;
    }

    const WorldDescription& world_;
    std::vector<Thing> things_;
    std::vector<Part> parts_;
    std::vector<Box> boxes_;  ///< around parts_
    std::map<std::pair<int, int>, Parting> partings_;
};

}  // namespace

StartOverlaps startOverlaps(const WorldDescription& world) {
    return Check(world).result();
}

std::vector<Box> boxesOf(const BodyDescription& body) {
    const Vec3 edges = body.size.cwiseQuotient(body.cells.cast<double>());
    const Vec3 origin = body.position - Vec3(body.size[0] / 2, 0, body.size[2] / 2);
    std::vector<Box> boxes;
    const auto add = [&](const IVec3& from, const IVec3& to) {
        boxes.push_back({origin + from.cast<double>().cwiseProduct(edges),
                         origin + (to.array() + 1).matrix().cast<double>().cwiseProduct(edges)});
    };
    const bool whole = std::none_of(body.regions.begin(), body.regions.end(),
                                    [](const RegionDescription& r) { return r.material < 0; });
    if (whole) {
        add(IVec3::Zero(), body.cells - IVec3::Ones());
        return boxes;
    }
    // From the first cell that is left as far along x as there are cells, then row after row along
    // y, then layer after layer.
    Presence left(body);
    for (int z = 0; z < body.cells[2]; ++z)
        for (int y = 0; y < body.cells[1]; ++y)
            for (int x = 0; x < body.cells[0]; ++x) {
                const IVec3 from(x, y, z);
                if (!left(from)) continue;
                IVec3 to = from;
                for (int axis = 0; axis < 3; ++axis)
                    while (to[axis] + 1 < body.cells[axis]) {
                        IVec3 next = from, last = to;
                        next[axis] = last[axis] = to[axis] + 1;
                        if (!left.all(next, last)) break;
                        ++to[axis];
                    }
                left.remove(from, to);
                add(from, to);
            }
    return boxes;
}

}  // namespace sunder::core
