#include "cpu/objects.hpp"

#include <algorithm>
#include <cmath>

#include "core/sleep.hpp"

namespace sunder {
namespace {

/// The corners of an object's core: the points with which it meets planes and other objects.
std::vector<RoundedBox> cornersOf(const RoundedBox& box) {
    std::vector<RoundedBox> corners;
    for (int corner = 0; corner < kCorners; ++corner) {
        Vec3 local;
        bool repeated = false;
        for (int axis = 0; axis < 3; ++axis) {
            const bool high = corner >> axis & 1;
            repeated |= high && box.half[axis] == 0;
            local[axis] = (high ? 1 : -1) * box.half[axis];
        }
        if (repeated) continue;
        corners.push_back({box.centre + box.axes * local, box.axes, Vec3::Zero(), box.radius});
    }
    return corners;
}

}  // namespace

Objects::Objects(const World& world)
    : world_(world),
      barriers_(barriers(world.description())),
      near_(world.bodies().size()),
      hit_(world.bodies().size()),
      cellTouches_(static_cast<std::size_t>(world.cellCount())),
      objectTouches_(world.objects().size()),
      impulses_(world.objects().size()) {
    for (const Body& body : world.bodies()) proxies_.push_back(contactProxy(body.cellSize));
}

void Objects::set(const std::vector<ObjectState>& states) {
    states_ = states;
    searchDue_ = true;
}

void Objects::startStep(std::int64_t step) {
    for (const Throw& thrown : world_.throws()) {
        if (thrown.step != step) continue;
        states_[thrown.object] = thrown.state;
        searchDue_ = true;
    }
}

bool Objects::moves(int object) const {
    const ObjectState& state = states_[object];
    const Object& kind = world_.objects()[object];
    return state.velocity.norm() + state.spin(kind).norm() * kind.reach() > kStirringSpeed;
}

void Objects::search(const Cells& cells, const std::vector<bool>& held) {
    searchDue_ = false;
    candidates_.clear();
    std::fill(near_.begin(), near_.end(), false);
    std::fill(hit_.begin(), hit_.end(), false);
    for (int body = 0; body < static_cast<int>(world_.bodies().size()); ++body) {
        if (!held[body]) continue;
        const Cells::Bounds bounds = cells.bounds(body);
        for (int object = 0; object < static_cast<int>(states_.size()); ++object)
            if (states_[object].present) findOf(object, body, cells, bounds);
    }
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cell < b.cell; });
}

void Objects::findOf(int index, int body, const Cells& cells, const Cells::Bounds& bounds) {
    const Object& object = world_.objects()[index];
    const ObjectState& state = states_[index];
    const RoundedBox box = boxOf(object, state);
    const Body& of = world_.bodies()[body];
    const double cellReach = of.cellSize.norm() / 2, spin = state.spin(object).norm();
    const auto margin = [&](double speed) {
        return std::max(0.5 * of.cellSize.minCoeff(),
                        1.1 * kContactInterval * world_.step() * (speed + spin * object.reach()));
    };
    const double reach = object.reach() + margin(state.velocity.norm() + of.speedLimit);
    for (int axis = 0; axis < 3; ++axis)
        if (state.position[axis] + reach < bounds.low[axis] ||
            state.position[axis] - reach > bounds.high[axis])
            return;
    for (int cell = of.firstCell; cell < of.firstCell + of.cellCount(); ++cell) {
        if (!world_.present(cell)) continue;
        const CellMotion motion = cells.motion(cell);
        Vec3 x = Vec3::Zero(), v = Vec3::Zero();
        for (int corner = 0; corner < kCorners; ++corner) {
            x += motion.position[corner] / kCorners;
            v += motion.velocity[corner] / kCorners;
        }
        const double distance = (x - box.nearest(x)).norm() - box.radius - cellReach;
        if (distance > margin((v - state.velocity).norm())) continue;
        candidates_.push_back({cell, index});
        near_[body] = true;
        if (moves(index)) hit_[body] = true;
    }
}

void Objects::push(Cells& cells) {
    active_.clear();
    std::fill(objectTouches_.begin(), objectTouches_.end(), 0);
    for (const Candidate& candidate : candidates_) cellTouches_[candidate.cell] = 0;
    for (const Candidate& candidate : candidates_) touchCell(candidate, cells);
    for (int object = 0; object < static_cast<int>(states_.size()); ++object) {
        if (!states_[object].present) continue;
        touchBarriers(object);
        for (int other = object + 1; other < static_cast<int>(states_.size()); ++other)
            if (states_[other].present) touchObjects(object, other);
    }
    std::fill(impulses_.begin(), impulses_.end(), Impulse{});
    for (const Active& active : active_) apply(active, cells);
}

void Objects::add(Active active) {
    if (!touches(active.touch, active.velocity, world_.step())) return;
    ++objectTouches_[active.object];
    if (active.other >= 0) ++objectTouches_[active.other];
    if (active.cell >= 0) ++cellTouches_[active.cell];
    active_.push_back(std::move(active));
}

void Objects::touchCell(const Candidate& candidate, const Cells& cells) {
    const int body = world_.bodyOf(candidate.cell);
    const Object& object = world_.objects()[candidate.object];
    const ObjectState& state = states_[candidate.object];
    const CellMotion motion = cells.motion(candidate.cell);
    const RoundedBox cell = motion.box(world_.bodies()[body].cellSize);
    Vec3 mean = Vec3::Zero();
    for (const Vec3& v : motion.velocity) mean += v / kCorners;
    Active active{};
    active.touch = sweptTouch(boxOf(object, state), cell, mean - state.velocity, world_.step());
    active.object = candidate.object;
    active.cell = candidate.cell;
    active.other = -1;
    active.weights = cornerWeights(cell, proxies_[body], active.touch.point);
    double squares = 0;
    active.velocity = -state.velocityAt(object, active.touch.point);
    for (int corner = 0; corner < kCorners; ++corner) {
        active.velocity += active.weights[corner] * motion.velocity[corner];
        squares += active.weights[corner] * active.weights[corner];
    }
    active.yield = yieldOf(kCorners * squares / world_.cellMass(candidate.cell));
    active.restitution =
        0.5 * (object.restitution + world_.laws()[world_.lawOf(candidate.cell)].restitution);
    active.friction = 0.5 * (object.friction + world_.materialOf(candidate.cell).friction);
    add(std::move(active));
}

void Objects::touchBarriers(int index) {
    const Object& object = world_.objects()[index];
    const ObjectState& state = states_[index];
    if (object.inverseMass == 0) return;
    const std::vector<RoundedBox> corners = cornersOf(boxOf(object, state));
    for (const Barrier& barrier : barriers_)
        for (const RoundedBox& corner : corners) {
            Active active{};
            active.touch.normal = -barrier.side * Vec3::Unit(barrier.axis);
            active.touch.gap = barrier.distance(corner.centre) - corner.radius;
            active.touch.point = corner.centre + corner.radius * active.touch.normal;
            active.object = index;
            active.cell = active.other = -1;
            active.velocity = -state.velocityAt(object, active.touch.point);
            active.restitution = object.restitution;
            active.friction = 0.5 * (object.friction + barrier.friction);
            add(std::move(active));
        }
}

void Objects::touchObjects(int a, int b) {
    const Object &first = world_.objects()[a], &second = world_.objects()[b];
    const ObjectState &stateA = states_[a], &stateB = states_[b];
    if (first.inverseMass == 0 && second.inverseMass == 0) return;
    const RoundedBox boxA = boxOf(first, stateA), boxB = boxOf(second, stateB);
    const Vec3 closing = stateB.velocity - stateA.velocity;
    const auto between = [&](const RoundedBox& from, const RoundedBox& to) {
        Active active{};
        active.touch = sweptTouch(from, to, closing, world_.step());
        active.object = a;
        active.cell = -1;
        active.other = b;
        active.velocity = stateB.velocityAt(second, active.touch.point) -
                          stateA.velocityAt(first, active.touch.point);
        active.restitution = 0.5 * (first.restitution + second.restitution);
        active.friction = 0.5 * (first.friction + second.friction);
        add(std::move(active));
    };
    between(boxA, boxB);
    if (boxA.half.isZero() || boxB.half.isZero()) return;
    for (const RoundedBox& corner : cornersOf(boxA)) between(corner, boxB);
    for (const RoundedBox& corner : cornersOf(boxB)) between(boxA, corner);
}

void Objects::apply(const Active& active, Cells& cells) {
    const Touch& touch = active.touch;
    const Object& object = world_.objects()[active.object];
    const ObjectState& state = states_[active.object];
    Yield yield = yieldOf(object, state, touch) * objectTouches_[active.object];
    if (active.cell >= 0) yield += active.yield * cellTouches_[active.cell];
    if (active.other >= 0)
        yield += yieldOf(world_.objects()[active.other], states_[active.other], touch) *
                 objectTouches_[active.other];
    if (yield.normal == 0) return;
    const Vec3 impulse = touchImpulse(touch, active.velocity, yield, active.restitution,
                                      active.friction, world_.step());
    const auto give = [&](int index, const Vec3& p) {
        impulses_[index].linear += p;
        impulses_[index].angular += (touch.point - states_[index].position).cross(p);
    };
    give(active.object, -impulse);
    if (active.other >= 0) give(active.other, impulse);
    if (active.cell < 0) return;
    cells.push(active.cell, active.weights, impulse / world_.step());
    if (watch_) watch_->push(active.cell, impulse.norm(), impulse.norm(), -1, active.object);
}

void Objects::move() {
    const double h = world_.step();
    for (std::size_t i = 0; i < states_.size(); ++i) {
        ObjectState& state = states_[i];
        const Object& object = world_.objects()[i];
        if (!state.present || object.inverseMass == 0) continue;
        const double kept = std::exp(-object.drag * h);
        state.velocity = kept * state.velocity + h * world_.description().gravity +
                         object.inverseMass * impulses_[i].linear;
        state.angularMomentum = kept * state.angularMomentum + impulses_[i].angular;
        Vec3 next = state.position + h * state.velocity;
        if (object.chain > 0) {
            const Vec3 along = next - object.hungFrom;
            if (const double length = along.norm(); length > object.chain) {
                const Vec3 outward = along / length;
                state.velocity -= std::max(0.0, state.velocity.dot(outward)) * outward;
                next = object.hungFrom + object.chain * outward;
            }
        }
        state.position = next;
        // A turn by the spin in the middle of the step.
        const auto turned = [&](const Vec3& spin, double time) {
            const double angle = spin.norm() * time;
            if (angle == 0) return state.orientation;
            return Eigen::Quaterniond(Eigen::AngleAxisd(std::min(angle, 1.0), spin.normalized()) *
                                      state.orientation);
        };
        ObjectState middle = state;
        middle.orientation = turned(state.spin(object), h / 2);
        state.orientation = turned(middle.spin(object), h).normalized();
    }
}

}  // namespace sunder
