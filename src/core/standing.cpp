#include "core/standing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/box_pairs.hpp"
#include "core/object_contact.hpp"
#include "core/room.hpp"

namespace sunder::core {
namespace {

/// Cells that reach into each other by no more than this, in edges, touch; by more, they are
/// somewhere else than a person would put them.
constexpr double kDeepest = 0.5;
/// What touches stands on it where the cosine between the way there and gravity is more than this.
constexpr double kBelow = 0.3;

/// Whether a rotation takes each axis to one of the axes, so that faces lie on faces.
bool isAligned(const Mat3& rotation) {
    constexpr double kAngle = 1e-6;  // rad: over a body of a thousand cells, a thousandth of one
    const auto aside = [](double x) { return std::min(std::abs(x), std::abs(std::abs(x) - 1)); };
    return rotation.unaryExpr(aside).maxCoeff() < kAngle;
}

bool near(const Box& a, const Box& b, double gap) {
    return (a.low.array() <= b.high.array() + gap).all() &&
           (b.low.array() <= a.high.array() + gap).all();
}

/// Which way two things touch: the second one's direction from the first.
struct Contact {
    bool touch = false;
    /// Whether the first stands on the second, and the second on the first, for their gravities.
    bool firstStands = false, secondStands = false;

    void add(const Vec3& direction, const Vec3& firstGravity, const Vec3& secondGravity) {
        touch = true;
        firstStands |= direction.dot(firstGravity) > kBelow * firstGravity.norm();
        secondStands |= -direction.dot(secondGravity) > kBelow * secondGravity.norm();
    }
};

/// Everything that may stand: bodies first, then objects.
class Things {
  public:
    Things(const World& world, const StandingQuery& query) : world_(world), query_(query) {
        const std::size_t count = world.bodies().size() + world.objects().size();
        neighbours_.resize(count);
        standsOn_.resize(count);
        carried_.resize(count);
        findContacts();
        for (const auto& [a, b] : query.joined) {
            neighbours_[a].push_back(b);
            neighbours_[b].push_back(a);
        }
        findFooting();
        carry();
    }

    std::vector<StandingGroup> groups() const {
        std::vector<StandingGroup> groups;
        std::vector<bool> seen(neighbours_.size());
        for (int body = 0; body < bodies(); ++body) {
            if (seen[body] || !takesPart(body)) continue;
            StandingGroup& group = groups.emplace_back();
            std::vector<int> open = {body};
            seen[body] = true;
            while (!open.empty()) {
                const int thing = open.back();
                open.pop_back();
                if (thing < bodies())
                    group.bodies.push_back(thing);
                else
                    group.objects.push_back(thing - bodies());
                for (const int other : neighbours_[thing]) {
                    if (seen[other] || !takesPart(other)) continue;
                    seen[other] = true;
                    open.push_back(other);
                }
            }
            std::sort(group.bodies.begin(), group.bodies.end());
            std::sort(group.objects.begin(), group.objects.end());
            const bool pulled =
                std::any_of(group.bodies.begin(), group.bodies.end(),
                            [&](int member) { return !world_.bodies()[member].gravity.isZero(); });
            if (!pulled) groups.pop_back();
        }
        return groups;
    }

  private:
    int bodies() const { return static_cast<int>(world_.bodies().size()); }
    int objects() const { return static_cast<int>(world_.objects().size()); }
    const ObjectDescription& object(int index) const { return world_.description().objects[index]; }

    bool there(int thing) const {
        if (thing < bodies()) return !query_.absentBodies[thing];
        return !query_.absentObjects[thing - bodies()] && object(thing - bodies()).position;
    }
    /// Held by what the world has from the start; it does not move whatever it carries.
    bool holds(int index) const { return object(index).unyielding() || object(index).hungFrom; }
    /// In the world from the start, and still, with nothing to hold it.
    bool lies(int index) const {
        const auto& throws = world_.throws();
        return object(index).velocity.isZero() && object(index).spin.isZero() && !holds(index) &&
               std::none_of(throws.begin(), throws.end(), [&](const Throw& thrown) {
                   return thrown.step == 0 && thrown.object == index;
               });
    }
    bool takesPart(int thing) const {
        return there(thing) && carried_[thing] && (thing < bodies() || lies(thing - bodies()));
    }
    Vec3 gravity(int thing) const {
        return thing < bodies() ? world_.bodies()[thing].gravity : world_.description().gravity;
    }

    void findContacts() {
        if (!world_.description().contact) return;
        findBodiesOnBodies();
        for (int index = 0; index < objects(); ++index) {
            const int thing = bodies() + index;
            if (!there(thing)) continue;
            for (int body = 0; body < bodies(); ++body)
                if (there(body)) join(thing, body, objectOnBody(index, body));
            for (int other = index + 1; other < objects(); ++other)
                if (there(bodies() + other))
                    join(thing, bodies() + other, objectOnObject(index, other));
        }
    }

    void findBodiesOnBodies() {
        std::vector<int> there;
        std::vector<Box> boxes;
        for (int body = 0; body < bodies(); ++body) {
            if (!this->there(body)) continue;
            there.push_back(body);
            Box& box = boxes.emplace_back(world_.bodies()[body].bounds());
            const Vec3 gap =
                Vec3::Constant(kStandingGap * world_.bodies()[body].cellSize.minCoeff());
            box.low -= gap;
            box.high += gap;
        }
        forEachOverlap(
            boxes, [&](int i, int j) { join(there[i], there[j], bodyOnBody(there[i], there[j])); });
    }

    Contact bodyOnBody(int a, int b) const {
        const Body &first = world_.bodies()[a], &second = world_.bodies()[b];
        Contact contact;
        const double edge = std::min(first.cellSize.minCoeff(), second.cellSize.minCoeff());
        const double gap = kStandingGap * edge;
        if (!near(first.bounds(), second.bounds(), gap)) return contact;
        // All along b's own axes: in the world, or from b's origin where one of them is turned.
        const bool turned = first.turned || second.turned;
        const Vec3 origin = turned ? Vec3::Zero() : second.origin;
        const Box all{origin, origin + second.size()};
        const Mat3 rotation = second.axes.transpose() * first.axes;
        const bool aligned = isAligned(rotation);
        for (int cell = first.firstCell; cell < first.firstCell + first.cellCount(); ++cell) {
            if (!world_.present(cell)) continue;
            const Vec3 own = first.coordinates(cell).cast<double>().cwiseProduct(first.cellSize);
            Box box{first.origin + own, first.origin + own + first.cellSize};
            if (turned) {
                const Vec3 middle = first.inWorld(own + 0.5 * first.cellSize) - second.origin;
                const Vec3 centre = second.axes.transpose() * middle;
                const Vec3 reach = rotation.cwiseAbs() * (0.5 * first.cellSize);
                box = {centre - reach, centre + reach};
            }
            if (!near(box, all, gap)) continue;
            if (aligned)
                cellOnBody(box, origin, a, b, edge, contact);
            else
                slantedCellOnBody(cell, box, a, b, edge, contact);
        }
        return contact;
    }

    /// First and last of a body's cells that a box reaches, by `gap` more. The box lies along the
    /// body's axes, where its own corner is at `origin`.
    static std::pair<IVec3, IVec3> cellsAround(const Body& body, const Vec3& origin, const Box& box,
                                               double gap) {
        IVec3 from, to;
        for (int axis = 0; axis < 3; ++axis) {
            const auto place = [&](double x) {
                return static_cast<int>(
                    std::clamp(std::floor((x - origin[axis]) / body.cellSize[axis]), 0.0,
                               body.cells[axis] - 1.0));
            };
            from[axis] = place(box.low[axis] - gap);
            to[axis] = place(box.high[axis] + gap);
        }
        return {from, to};
    }

    /// A cell of body a, and those of body b around it, all along b's axes.
    void cellOnBody(const Box& box, const Vec3& origin, int a, int b, double edge,
                    Contact& contact) const {
        const Body& body = world_.bodies()[b];
        const double gap = kStandingGap * edge;
        const auto [from, to] = cellsAround(body, origin, box, gap);
        for (int z = from[2]; z <= to[2]; ++z)
            for (int y = from[1]; y <= to[1]; ++y)
                for (int x = from[0]; x <= to[0]; ++x) {
                    if (!world_.present(body.cellAt({x, y, z}))) continue;
                    const Vec3 low =
                        origin + IVec3(x, y, z).cast<double>().cwiseProduct(body.cellSize);
                    const Vec3 above = low - box.high, below = box.low - (low + body.cellSize);
                    const Vec3 gaps = above.cwiseMax(below);
                    int axis = 0;
                    const double widest = gaps.maxCoeff(&axis);
                    const bool faces = (gaps.array() < -gap).count() == 2;
                    if (!faces || widest > gap || widest < -kDeepest * edge) continue;
                    const double side = above[axis] > below[axis] ? 1 : -1;
                    contact.add(side * body.axes.col(axis), gravity(a), gravity(b));
                }
    }

    /// The same where faces do not lie on faces: an edge or a corner on anything.
    void slantedCellOnBody(int cell, const Box& box, int a, int b, double edge,
                           Contact& contact) const {
        const Body &first = world_.bodies()[a], &second = world_.bodies()[b];
        const double gap = kStandingGap * edge;
        const RoundedBox own = boxAtStart(first, first.coordinates(cell));
        const auto [from, to] = cellsAround(second, Vec3::Zero(), box, gap);
        for (int z = from[2]; z <= to[2]; ++z)
            for (int y = from[1]; y <= to[1]; ++y)
                for (int x = from[0]; x <= to[0]; ++x) {
                    if (!world_.present(second.cellAt({x, y, z}))) continue;
                    const Touch touch = touchOf(own, boxAtStart(second, {x, y, z}));
                    if (touch.gap <= gap) contact.add(touch.normal, gravity(a), gravity(b));
                }
    }

    /// So sharp that what stands on an edge or a corner is within kStandingGap, and round enough
    /// for what lies in another cell by kOverlapShare.
    static RoundedBox boxAtStart(const Body& body, const IVec3& cell) {
        const double radius = kStandingGap / 2 * body.cellSize.minCoeff();
        const Vec3 middle = cell.cast<double>() + Vec3::Constant(0.5);
        return {body.inWorld(middle.cwiseProduct(body.cellSize)), body.axes,
                0.5 * body.cellSize - Vec3::Constant(radius), radius};
    }

    double thickness(int index) const { return 2 * object(index).halfSize.minCoeff(); }
    RoundedBox boxAtStart(int index) const {
        return sunder::core::boxOf(world_.objects()[index], initialState(object(index)));
    }
    /// Around an object and everything that it may touch.
    Box boundsOf(int index) const {
        const Vec3 reach = Vec3::Constant(world_.objects()[index].reach());
        return {*object(index).position - reach, *object(index).position + reach};
    }

    Contact objectOnBody(int index, int bodyIndex) const {
        const Body& body = world_.bodies()[bodyIndex];
        Contact contact;
        const double gap = kStandingGap * std::min(body.cellSize.minCoeff(), thickness(index));
        const Box bounds = boundsOf(index);
        if (!near(bounds, body.bounds(), gap)) return contact;
        const RoundedBox box = boxAtStart(index);
        for (int cell = body.firstCell; cell < body.firstCell + body.cellCount(); ++cell) {
            if (!world_.present(cell)) continue;
            CellMotion motion{};
            Box around;
            for (int corner = 0; corner < kCorners; ++corner) {
                const Vec3& x = motion.position[corner] =
                    world_.restPosition(kCorners * cell + corner);
                if (corner == 0) around = {x, x};
                around.include({x, x});
            }
            if (!near(bounds, around, gap)) continue;
            const Touch touch = touchOf(box, motion.box(body.cellSize));
            if (touch.gap <= gap)
                contact.add(touch.normal, world_.description().gravity, body.gravity);
        }
        return contact;
    }

    Contact objectOnObject(int a, int b) const {
        Contact contact;
        const double gap = kStandingGap * std::min(thickness(a), thickness(b));
        if (!near(boundsOf(a), boundsOf(b), gap)) return contact;
        const Touch touch = touchOf(boxAtStart(a), boxAtStart(b));
        const Vec3& gravity = world_.description().gravity;
        if (touch.gap <= gap) contact.add(touch.normal, gravity, gravity);
        return contact;
    }

    void join(int first, int second, const Contact& contact) {
        if (!contact.touch) return;
        neighbours_[first].push_back(second);
        neighbours_[second].push_back(first);
        if (contact.firstStands) standsOn_[second].push_back(first);
        if (contact.secondStands) standsOn_[first].push_back(second);
    }

    /// Anchors, barriers, and objects that do not move.
    void findFooting() {
        const std::vector<Barrier> all = barriers(world_.description());
        for (int body = 0; body < bodies(); ++body)
            carried_[body] = there(body) && foots(body, all);
        for (int index = 0; index < objects(); ++index) {
            const int thing = bodies() + index;
            if (!there(thing)) continue;
            carried_[thing] = holds(index) || (lies(index) && liesOnBarrier(index, all));
        }
    }

    bool foots(int index, const std::vector<Barrier>& all) const {
        const Body& body = world_.bodies()[index];
        const double gap = kStandingGap * body.cellSize.minCoeff();
        if (isAnchored(world_, index)) return true;
        for (int cell = body.firstCell; cell < body.firstCell + body.cellCount(); ++cell) {
            if (!world_.present(cell)) continue;
            for (int node = kCorners * cell; node < kCorners * (cell + 1); ++node) {
                const Vec3 x = world_.restPosition(node);
                for (const Barrier& barrier : all)
                    if (pullsAt(barrier, body.gravity) && barrier.distance(x) <= gap) return true;
            }
        }
        return false;
    }

    static bool pullsAt(const Barrier& barrier, const Vec3& gravity) {
        return -barrier.side * gravity[barrier.axis] > kBelow * gravity.norm();
    }

    bool liesOnBarrier(int index, const std::vector<Barrier>& all) const {
        const RoundedBox box = boxAtStart(index);
        return std::any_of(all.begin(), all.end(), [&](const Barrier& barrier) {
            const double reach =
                (box.axes.row(barrier.axis).transpose().cwiseProduct(box.half)).cwiseAbs().sum() +
                box.radius;
            return pullsAt(barrier, world_.description().gravity) &&
                   barrier.distance(box.centre) - reach <= kStandingGap * thickness(index);
        });
    }

    void carry() {
        std::vector<int> open;
        for (int thing = 0; thing < static_cast<int>(carried_.size()); ++thing)
            if (carried_[thing]) open.push_back(thing);
        while (!open.empty()) {
            const int thing = open.back();
            open.pop_back();
            for (const int other : standsOn_[thing]) {
                if (carried_[other] || (other >= bodies() && !lies(other - bodies()))) continue;
                carried_[other] = true;
                open.push_back(other);
            }
        }
    }

    const World& world_;
    const StandingQuery& query_;
    std::vector<std::vector<int>> neighbours_;  ///< what touches it
    std::vector<std::vector<int>> standsOn_;    ///< what stands on it
    std::vector<bool> carried_;
};

}  // namespace

bool isAnchored(const World& world, int index) {
    const Body& body = world.bodies()[index];
    for (int node = kCorners * body.firstCell;
         node < kCorners * (body.firstCell + body.cellCount()); ++node)
        if (world.anchored(node)) return true;
    return false;
}

std::vector<StandingGroup> standingGroups(const World& world, const StandingQuery& query) {
    return Things(world, query).groups();
}

}  // namespace sunder::core
