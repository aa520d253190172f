#include "cpu/objects.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/links.hpp"
#include "cpu/object_push.hpp"

namespace sunder::cpu {

using namespace core;

namespace {

/// A search looks farther by a tenth of the way that things come until the next one, or at least as
/// far as half a cell: nothing that comes by this share of a cell's shortest edge more is missed.
constexpr double kSearchLeeway = 0.04;

/// m/s: gained in each step from one search to the next, it makes no longer way than that.
double gentlePush(const World& world) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const Body& body : world.bodies()) shortest = std::min(shortest, body.cellSize.minCoeff());
    return kSearchLeeway * shortest / (world.contactInterval() * world.contactTime());
}

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
      disturbed_(world.objects().size()),
      asleep_(world.objects().size()),
      rests_(world.objects().size()),
      heaviest_(massOf(world)),
      settlingSpeed_(settlingSpeed(world)),
      gentlePush_(gentlePush(world)),
      sleepSteps_(sleepSteps(world)),
      cellTouches_(static_cast<std::size_t>(world.cellCount())),
      objectTouches_(world.objects().size()),
      impulses_(world.objects().size()) {
    for (const Body& body : world.bodies()) proxies_.push_back(contactProxy(body.cellSize));
}

void Objects::set(const std::vector<ObjectState>& states) {
    states_ = states;
    searchDue_ = true;
    std::fill(asleep_.begin(), asleep_.end(), false);
    std::fill(rests_.begin(), rests_.end(), Rest{});
}

void Objects::archive(Archive& a) {
    a.section("objects");
    std::vector<ObjectState> states = states_;
    for (ObjectState& state : states) core::archive(a, state);
    std::vector<Rest> rests = rests_;
    for (Rest& rest : rests) {
        rest.unrest.fastest = a.real(rest.unrest.fastest, 0.);
        rest.unrest.touched = a.flag(rest.unrest.touched);
        rest.unrest.hung = a.flag(rest.unrest.hung);
        rest.calmSteps = a.whole(rest.calmSteps, 0, 1 << 30);
    }
    const bool searchDue = a.flag(searchDue_);
    std::vector<Candidate> candidates = candidates_;
    const auto most = states.size() * static_cast<std::size_t>(world_.cellCount());
    a.list(candidates, most, [&](Candidate& candidate) {
        candidate.cell = a.whole(candidate.cell, 0, world_.cellCount() - 1);
        candidate.object = a.whole(candidate.object, 0, static_cast<int>(states.size()) - 1);
        a.require(world_.present(candidate.cell));
    });
    if (!a.reads()) return;
    states_ = std::move(states);
    rests_ = std::move(rests);
    std::fill(asleep_.begin(), asleep_.end(), false);
    searchDue_ = searchDue;
    candidates_ = std::move(candidates);
    std::fill(near_.begin(), near_.end(), false);
    for (const Candidate& candidate : candidates_) near_[world_.bodyOf(candidate.cell)] = true;
}

void Objects::scaleVelocities(double factor) {
    for (int object = 0; object < static_cast<int>(states_.size()); ++object) {
        wake(object);
        states_[object].velocity *= factor;
        states_[object].angularMomentum *= factor;
    }
}

void Objects::startStep(std::int64_t step) {
    for (const Throw& thrown : world_.throws())
        if (thrown.step == step) set(thrown.object, thrown.state);
}

void Objects::set(int object, const ObjectState& state) {
    states_[object] = state;
    wake(object);
    searchDue_ = true;
}

void Objects::accelerate(std::span<const Blast> blasts) {
    const double h = world_.step();
    for (int index = 0; index < static_cast<int>(states_.size()); ++index) {
        ObjectState& state = states_[index];
        if (!state.present || still(index)) continue;
        const Object& object = world_.objects()[index];
        const ObjectPush push = objectPush(boxOf(object, state), blasts);
        if (push.isZero()) continue;
        // move() lets motion fade before it adds.
        const double gain = share(index) * h / std::exp(-object.drag * h);
        ObjectState gained = state;
        gained.velocity = gain * push.acceleration;
        gained.angularMomentum = gain / object.inverseMass * push.torque;
        state.velocity += gained.velocity;
        state.angularMomentum += gained.angularMomentum;
        searchDue_ |= speedOf(index, gained) > gentlePush_;
    }
}

double Objects::speedOf(int object, const ObjectState& state) const {
    const Object& kind = world_.objects()[object];
    return state.velocity.norm() + state.spin(kind).norm() * kind.reach();
}

void Objects::look(int steps) {
    for (Rest& rest : rests_) {
        rest.calmSteps = calm(rest.unrest) ? rest.calmSteps + steps : 0;
        rest.unrest = {};
    }
}

RestIslands::Status Objects::restStatus(int object) const {
    using Status = RestIslands::Status;
    if (!states_[object].present || world_.objects()[object].inverseMass == 0) return Status::Apart;
    if (asleep_[object]) return Status::Asleep;
    return rests_[object].calmSteps >= sleepSteps_ ? Status::Ready : Status::Restless;
}

void Objects::fallAsleep(int object) {
    asleep_[object] = true;
    states_[object].velocity.setZero();
    states_[object].angularMomentum.setZero();
}

void Objects::wake(int object) {
    asleep_[object] = false;
    rests_[object] = {};
}

bool Objects::anyAwake() const {
    for (int object = 0; object < static_cast<int>(states_.size()); ++object)
        if (states_[object].present && (!still(object) || speed(object) > 0)) return true;
    return false;
}

void Objects::search(const Cells& cells, const std::vector<bool>& held) {
    searchDue_ = false;
    candidates_.clear();
    std::fill(near_.begin(), near_.end(), false);
    std::fill(hit_.begin(), hit_.end(), false);
    std::fill(disturbed_.begin(), disturbed_.end(), false);
    for (int body = 0; body < static_cast<int>(world_.bodies().size()); ++body) {
        if (!held[body]) continue;
        const Cells::Bounds bounds = cells.bounds(body);
        for (int object = 0; object < static_cast<int>(states_.size()); ++object)
            if (states_[object].present) findOf(object, body, cells, bounds);
    }
    findDisturbed();
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
                        1.1 * world_.contactTime() * (speed + spin * object.reach()));
    };
    const double reach = object.reach() + cellReach + margin(state.velocity.norm());
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
        if (asleep_[index] && v.norm() > kStirringSpeed) disturbed_[index] = true;
    }
}

/// Sleeping objects that one which moves may come to touch before the next search.
void Objects::findDisturbed() {
    const auto count = static_cast<int>(states_.size());
    for (int sleeper = 0; sleeper < count; ++sleeper) {
        if (!asleep_[sleeper]) continue;
        const RoundedBox box = boxOf(world_.objects()[sleeper], states_[sleeper]);
        for (int other = 0; other < count; ++other) {
            if (!states_[other].present || still(other) || !moves(other)) continue;
            const Touch touch = touchOf(box, boxOf(world_.objects()[other], states_[other]));
            if (touch.gap <= 1.1 * world_.contactTime() * speed(other)) disturbed_[sleeper] = true;
        }
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
    if (active.cell < 0) {
        const double lighter =
            std::min(share(active.object), active.other >= 0 ? share(active.other) : 1);
        if (active.touch.gap < 0) active.touch.gap *= std::max(kLoadedDepth, lighter);
        if (lighter < 1) limitDepth(active.touch, settlingSpeed_, world_.step());
    }
    limitDepth(active.touch, world_.pushSpeed(), world_.step());
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
    if (asleep_[candidate.object] && motion.still()) return;  // they sleep together
    const RoundedBox cell = motion.box(world_.bodies()[body].cellSize);
    Vec3 mean = Vec3::Zero();
    for (const Vec3& v : motion.velocity) mean += v / kCorners;
    Active active{};
    const RoundedBox box = boxOf(object, state);
    active.touch = sweptTouch(box, cell, mean - state.velocity, world_.step());
    if (active.touch.gap < 0) pushOut(active.touch, box, cell, candidate.cell, cells);
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

/// Where the centre or the core of an object is in a body.
void Objects::pushOut(Touch& touch, const RoundedBox& object, const RoundedBox& box, int cell,
                      const Cells& cells) const {
    const Body& body = world_.bodies()[world_.bodyOf(cell)];
    const Vec3 below =
        (body.coordinates(cell).cast<double>() + Vec3::Constant(0.5)).cwiseProduct(body.cellSize);
    const Vec3 above = body.cells.cast<double>().cwiseProduct(body.cellSize) - below;
    double depth = 0;
    const Vec3 way = wayOut(box, below, above, object.centre, depth);
    if (depth <= 0 && touch.gap > -object.radius - box.radius) return;
    for (int corner = 0; corner < kCorners; ++corner)
        if (cells.links(cell, corner) != wholeMask(world_, cell, corner)) return;
    touch.normal = -way;
    touch.gap = std::min(touch.gap, -depth);
}

void Objects::touchBarriers(int index) {
    const Object& object = world_.objects()[index];
    const ObjectState& state = states_[index];
    if (still(index)) return;
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

bool Objects::outOfReach(int a, int b) const {
    const Object &first = world_.objects()[a], &second = world_.objects()[b];
    const ObjectState &stateA = states_[a], &stateB = states_[b];
    const double distance = (stateB.position - stateA.position).norm();
    const double reach = first.reach() + second.reach();
    const double gap = 0.99 * distance - reach;  // less what rounding may add
    double fastest = (stateB.velocity - stateA.velocity).norm();
    if (gap <= world_.step() * fastest) return false;
    // Where they would touch is between them, and no farther from a centre than this.
    fastest += (stateA.spin(first).norm() + stateB.spin(second).norm()) * (distance + reach);
    return gap > world_.step() * fastest;
}

void Objects::touchObjects(int a, int b) {
    const Object &first = world_.objects()[a], &second = world_.objects()[b];
    const ObjectState &stateA = states_[a], &stateB = states_[b];
    if (still(a) && still(b)) return;
    if (outOfReach(a, b)) return;
    const RoundedBox boxA = boxOf(first, stateA), boxB = boxOf(second, stateB);
    const Vec3 closing = stateB.velocity - stateA.velocity;
    const auto between = [&](const Touch& touch) {
        Active active{};
        active.touch = touch;
        active.object = a;
        active.cell = -1;
        active.other = b;
        active.velocity = stateB.velocityAt(second, active.touch.point) -
                          stateA.velocityAt(first, active.touch.point);
        active.restitution = 0.5 * (first.restitution + second.restitution);
        active.friction = 0.5 * (first.friction + second.friction);
        add(std::move(active));
    };
    const auto swept = [&](const RoundedBox& from, const RoundedBox& to) {
        return sweptTouch(from, to, closing, world_.step());
    };
    const Touch touch = swept(boxA, boxB);
    if (touch.gap <= -boxA.radius - boxB.radius) return between(deepTouch(boxA, boxB));
    between(touch);
    if (boxA.half.isZero() || boxB.half.isZero()) return;
    for (const RoundedBox& corner : cornersOf(boxA)) between(swept(corner, boxB));
    for (const RoundedBox& corner : cornersOf(boxB)) between(swept(boxA, corner));
}

/// What an object gives way, with its share of the mass for each of its touches.
Yield Objects::yield(int object, const Touch& touch) const {
    if (still(object)) return {};
    return yieldOf(world_.objects()[object], states_[object], touch) * objectTouches_[object];
}

void Objects::apply(const Active& active, Cells& cells) {
    const Touch& touch = active.touch;
    Yield yield = this->yield(active.object, touch);
    if (active.cell >= 0) yield += active.yield * cellTouches_[active.cell];
    if (active.other >= 0) yield += this->yield(active.other, touch);
    if (yield.normal == 0) return;
    const Vec3 impulse = touchImpulse(touch, active.velocity, yield, active.restitution,
                                      active.friction, world_.step());
    const bool presses = active.velocity.dot(touch.normal) >= -kPressingSpeed;
    const double stopping = stoppingPart(touch, active.velocity, yield, impulse);
    const auto give = [&](int index, const Vec3& p) {
        Impulse& given = impulses_[index];
        given.sum.all += p;
        if (active.cell >= 0) {
            given.sum.cells += p;
        } else if (presses) {
            given.sum.pressing.add(p);
            given.sum.stopping.add((index == active.object ? -stopping : stopping) * touch.normal);
        }
        given.angular += (touch.point - states_[index].position).cross(p);
    };
    give(active.object, -impulse);
    if (active.other >= 0) give(active.other, impulse);
    if (active.cell < 0) return;
    cells.push(active.cell, active.weights, impulse / world_.step());
    if (watch_) watch_->push(active.cell, impulse.norm(), impulse.norm(), -1, active.object);
}

void Objects::move() {
    for (int object = 0; object < static_cast<int>(states_.size()); ++object) {
        if (!states_[object].present) continue;
        if (world_.objects()[object].inverseMass == 0)
            carry(object);
        else if (!asleep_[object])
            move(object, impulses_[object]);
    }
}

void Objects::carry(int object) {
    ObjectState& state = states_[object];
    state.position += world_.step() * state.velocity;
    state.orientation = turnedFreely(world_.objects()[object], state, world_.step());
}

void Objects::move(int index, const Impulse& given) {
    const double h = world_.step();
    ObjectState& state = states_[index];
    const Object& object = world_.objects()[index];
    ObjectUnrest& unrest = rests_[index].unrest;
    TouchSum sum = given.sum;
    const double kept = std::exp(-object.drag * h), share = this->share(index);
    state.velocity = kept * state.velocity +
                     share * (h * world_.description().gravity + object.inverseMass * sum.all);
    state.angularMomentum = kept * state.angularMomentum + share * given.angular;
    Vec3 next = state.position + h * state.velocity;
    if (object.chain > 0) {
        const Vec3 along = next - object.hungFrom;
        if (const double length = along.norm(); length > object.chain) {
            const Vec3 outward = along / length;
            const double taken = std::max(0.0, state.velocity.dot(outward));
            state.velocity -= taken * outward;
            next = object.hungFrom + object.chain * outward;
            sum.chain = -taken / (share * object.inverseMass) * outward;
            unrest.hung = true;
        }
    }
    state.position = next;
    state.orientation = turnedFreely(object, state, h);
    state.load = loadAfter(object, state.load, sum, h, heaviest_);
    // What weighs more from now on has no more momentum for it.
    const double lighter = std::min(1.0, this->share(index) / share);
    state.velocity *= lighter;
    state.angularMomentum *= lighter;
    unrest.fastest = std::max(unrest.fastest, speed(index));
    unrest.touched |= objectTouches_[index] > 0;
}

}  // namespace sunder::cpu
