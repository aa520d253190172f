#include "core/object_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/world.hpp"

namespace sunder::core {
namespace {

constexpr double kStandardGravity = 9.81;  // m/s²

}  // namespace

Vec3 RoundedBox::nearest(const Vec3& x) const {
    const Vec3 local = axes.transpose() * (x - centre);
    return centre + axes * local.cwiseMax(-half).cwiseMin(half);
}

RoundedBox boxOf(const Object& object, const ObjectState& state) {
    return {state.position, state.orientation.toRotationMatrix(), object.core, object.radius};
}

RoundedBox CellMotion::box(const Vec3& edges) const {
    RoundedBox box;
    Mat3 mean = Mat3::Zero();  // columns: edges along x, y, z
    for (int corner = 0; corner < kCorners; ++corner) {
        box.centre += position[corner] / kCorners;
        for (int axis = 0; axis < 3; ++axis)
            mean.col(axis) += (corner >> axis & 1 ? 0.25 : -0.25) * position[corner];
    }
    // Gram–Schmidt; a cell squashed flat keeps the world's axes.
    const auto normalized = [](const Vec3& v, const Vec3& otherwise) {
        const double length = v.norm();
        return length > 1e-6 ? Vec3(v / length) : otherwise;
    };
    box.axes.col(0) = normalized(mean.col(0), Vec3::UnitX());
    const Vec3 across = mean.col(1) - box.axes.col(0) * box.axes.col(0).dot(mean.col(1));
    box.axes.col(1) = normalized(across, box.axes.col(0).unitOrthogonal());
    box.axes.col(2) = box.axes.col(0).cross(box.axes.col(1));
    box.radius = kCellRoundness * edges.minCoeff();
    for (int axis = 0; axis < 3; ++axis) {
        const double edge = std::abs(box.axes.col(axis).dot(mean.col(axis)));
        box.half[axis] = 0.5 * std::clamp(edge, 0.5 * edges[axis], 2 * edges[axis]) - box.radius;
    }
    return box;
}

std::array<double, kCorners> cornerWeights(const RoundedBox& cell, const ContactProxy& proxy,
                                           const Vec3& x) {
    const Vec3 local = cell.axes.transpose() * (x - cell.centre);
    Vec3 place;
    for (int axis = 0; axis < 3; ++axis) {
        const double margin = 0.5 / proxy.count[axis];
        place[axis] = std::clamp(0.5 + 0.5 * local[axis] / (cell.half[axis] + cell.radius), margin,
                                 1 - margin);
    }
    return trilinearWeights(place);
}

Touch touchOf(const RoundedBox& from, const RoundedBox& to) {
    Vec3 x = to.centre, y = from.nearest(x);
    for (int i = 0; i < kProjections; ++i) {
        x = to.nearest(y);
        y = from.nearest(x);
    }
    const double radii = from.radius + to.radius;
    double distance = (x - y).norm();
    Vec3 apart = x - y;
    if (distance < 1e-3 * radii) {  // the cores meet
        x = to.centre;
        y = from.nearest(x);
        apart = x - y;
        if (apart.norm() < 1e-3 * radii) apart = x - from.centre;
        distance = 0;
    }
    Touch touch;
    if (const double length = apart.norm(); length > 1e-6 * radii) touch.normal = apart / length;
    touch.gap = distance - radii;
    touch.point = 0.5 * (y + from.radius * touch.normal + x - to.radius * touch.normal);
    return touch;
}

Touch sweptTouch(const RoundedBox& from, const RoundedBox& to, const Vec3& velocity, double step) {
    const Touch start = touchOf(from, to);
    const double speed = velocity.norm(), radii = from.radius + to.radius;
    // Near enough to meet, and too fast for the normal to stay what it is.
    if (start.gap <= 0 || start.gap > step * speed || step * speed < 0.1 * radii) return start;
    RoundedBox moved = to;
    Touch touch = start;
    double time = 0;
    for (int i = 0; i < kAdvances && touch.gap > 0.02 * radii; ++i) {
        time += touch.gap / speed;
        if (time > step)
            return start.gap > 0 ? Touch{start.normal, start.point, speed * step} : start;
        moved.centre = to.centre + time * velocity;
        touch = touchOf(from, moved);
    }
    touch.gap = time * std::max(0.0, -velocity.dot(touch.normal));
    return touch;
}

void limitDepth(Touch& touch, double speed, double step) {
    touch.gap = std::max(touch.gap, -speed * std::max(kPartingTime, step / kContactStiffness));
}

Touch deepTouch(const RoundedBox& from, const RoundedBox& to) {
    const Vec3 apart = to.centre - from.centre;
    Touch touch;
    touch.point = from.centre + 0.5 * apart;
    touch.gap = -std::numeric_limits<double>::infinity();
    for (const RoundedBox* box : {&from, &to})
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 n = box->axes.col(axis);
            const double along = apart.dot(n);
            double gap = std::abs(along) - from.radius - to.radius;
            for (const RoundedBox* reaches : {&from, &to})
                gap -= (reaches->axes.transpose() * n).cwiseAbs().dot(reaches->half);
            if (gap <= touch.gap) continue;
            touch.gap = gap;
            touch.normal = along < 0 ? Vec3(-n) : n;
        }
    return touch;
}

Vec3 wayOut(const RoundedBox& cell, const Vec3& below, const Vec3& above, const Vec3& x,
            double& depth) {
    const Vec3 local = cell.axes.transpose() * (x - cell.centre);
    const Vec3 toLow = local + below, toHigh = above - local;
    int low = 0, high = 0;
    const double down = toLow.minCoeff(&low), up = toHigh.minCoeff(&high);
    depth = std::min(down, up);
    return up <= down ? Vec3(cell.axes.col(high)) : Vec3(-cell.axes.col(low));
}

double partingSpeed(double gap, double step) {
    return gap > 0 ? -gap / step : -gap / std::max(kPartingTime, step / kContactStiffness);
}

double loadShare(const Object& object, const ObjectState& state) {
    return 1 / std::max(1.0, kLoadMargin * state.load * object.inverseMass);
}

double loadAfter(const Object& object, double load, const TouchSum& sum, double step, double most) {
    const auto squeeze = [&](const TouchSum::Pressing& p) {
        const auto against = [&](const Vec3& q) {
            return (0.5 * (p.sizes + q.cwiseAbs() - (p.sum + q).cwiseAbs())).maxCoeff();
        };
        return std::max(against(sum.cells), against(sum.chain)) / (step * kStandardGravity);
    };
    const bool pressed = !sum.pressing.sizes.isZero(0);
    const double kept = std::exp(-step / (pressed ? kLoadTime : kUnloadTime));
    const double following = kept * load + (1 - kept) * squeeze(sum.pressing);
    const double growing = std::exp(step / kGrowthTime) * std::max(load, 1 / object.inverseMass);
    return std::min(most, std::max(following, std::min(growing, squeeze(sum.stopping))));
}

double stoppingPart(const Touch& touch, const Vec3& velocity, const Yield& yield,
                    const Vec3& impulse) {
    return std::min(std::max(0.0, impulse.dot(touch.normal)),
                    std::max(0.0, -velocity.dot(touch.normal)) / yield.normal);
}

double massOf(const World& world) {
    double sum = 0;
    for (int cell = 0; cell < world.cellCount(); ++cell)
        if (world.present(cell)) sum += world.cellMass(cell);
    for (const Object& object : world.objects())
        if (object.inverseMass > 0) sum += 1 / object.inverseMass;
    return sum;
}

double settlingSpeed(const World& world) {
    return 20 * std::max(kStandardGravity, world.description().gravity.norm()) * world.step();
}

Yield yieldOf(const Object& object, const ObjectState& state, const Touch& touch) {
    const Vec3 arm = touch.point - state.position;
    const Vec3 turned = state.orientation.conjugate() * arm.cross(touch.normal);
    return Yield{object.inverseMass + turned.dot(object.inverseInertia.cwiseProduct(turned)),
                 object.inverseMass + arm.squaredNorm() * object.inverseInertia.maxCoeff()} *
           loadShare(object, state);
}

Vec3 touchImpulse(const Touch& touch, const Vec3& velocity, const Yield& yield, double restitution,
                  double friction, double step) {
    const double along = velocity.dot(touch.normal);
    double parting = partingSpeed(touch.gap, step);
    if (along < -kBounceSpeed) parting = std::max(parting, -restitution * along);
    const double push = std::max(0.0, parting - along) / yield.normal;
    const Vec3 sliding = velocity - along * touch.normal;
    const double speed = sliding.norm();
    const double drag = std::min(friction * push, speed / yield.tangential);
    return push * touch.normal - (speed > 0 ? drag / speed : 0) * sliding;
}

}  // namespace sunder::core
