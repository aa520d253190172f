#include "view/orbit_camera.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace sunder::view {

using namespace core;

namespace {

/// Just short of straight up or down, where "up" would flip.
constexpr double kSteepest = 1.55;
constexpr double kNearest = 0.05, kFarthest = 1000;  // m

}  // namespace

void OrbitCamera::setHome(const scene::CameraDescription& home, std::optional<double> clearance) {
    clearance_ = clearance;
    moved_ = false;
    target_ = home.target;
    fieldOfView_ = home.fieldOfView;
    Vec3 eye = home.position;
    if (clearance) eye[1] = std::max(eye[1], *clearance);
    const Vec3 back = eye - home.target;
    distance_ = std::clamp(back.norm(), kNearest, kFarthest);
    yaw_ = std::atan2(back[0], back[2]);
    pitch_ = std::clamp(std::asin(std::clamp(back[1] / std::max(back.norm(), 1e-9), -1., 1.)),
                        -kSteepest, kSteepest);
    keepAbove();
}

void OrbitCamera::setClearance(std::optional<double> clearance) {
    clearance_ = clearance;
    keepAbove();
}

Vec3 OrbitCamera::forward() const {
    return -Vec3(std::sin(yaw_) * std::cos(pitch_), std::sin(pitch_),
                 std::cos(yaw_) * std::cos(pitch_));
}

Vec3 OrbitCamera::right() const {
    return Vec3(std::cos(yaw_), 0, -std::sin(yaw_));
}

void OrbitCamera::orbit(double toTheRight, double upwards) {
    moved_ |= toTheRight != 0 || upwards != 0;
    yaw_ = std::remainder(yaw_ + toTheRight, 2 * std::numbers::pi);
    pitch_ = std::clamp(pitch_ + upwards, lowest(), kSteepest);
}

void OrbitCamera::pan(double toTheRight, double upwards) {
    moved_ |= toTheRight != 0 || upwards != 0;
    const double height = 2 * distance_ * std::tan(fieldOfView_ * std::numbers::pi / 360);
    target_ -= height * (toTheRight * right() + upwards * up());
    keepNear();
    keepAbove();
}

void OrbitCamera::zoom(double factor) {
    moved_ |= factor != 1;
    double nearest = kNearest;
    // Towards a target that is lower than the eye may be.
    if (clearance_ && target_[1] < *clearance_ && pitch_ > 0)
        nearest = std::max(nearest, (*clearance_ - target_[1]) / std::sin(pitch_));
    distance_ = std::clamp(distance_ / factor, std::min(nearest, kFarthest), kFarthest);
    pitch_ = std::max(pitch_, lowest());
}

void OrbitCamera::move(double ahead, double toTheRight, double upwards) {
    moved_ |= ahead != 0 || toTheRight != 0 || upwards != 0;
    const Vec3 level(-std::sin(yaw_), 0, -std::cos(yaw_));
    target_ += ahead * level + toTheRight * right() + upwards * Vec3(0, 1, 0);
    keepNear();
    keepAbove();
}

/// A scene's file has bounds for its camera, too.
void OrbitCamera::keepNear() {
    target_ = target_.cwiseMax(-kFarthest).cwiseMin(kFarthest);
}

double OrbitCamera::lowest() const {
    if (!clearance_) return -kSteepest;
    const double rise = (*clearance_ - target_[1]) / distance_;
    return std::clamp(std::asin(std::clamp(rise, -1., 1.)), -kSteepest, kSteepest);
}

/// Looking as it does.
void OrbitCamera::keepAbove() {
    if (!clearance_) return;
    target_[1] += std::max(0., *clearance_ - eye()[1]);
    if (target_[1] >= 0) return;
    // The same view, turning around the place on the ground that it shows.
    const Vec3 from = eye();
    const double share = from[1] / (from[1] - target_[1]);
    target_ = from + share * (target_ - from);
    distance_ *= share;
}

scene::CameraDescription OrbitCamera::description() const {
    return {eye(), target_, fieldOfView_};
}

Vec3 OrbitCamera::ray(double x, double y, double aspect) const {
    const double tangent = std::tan(fieldOfView_ * std::numbers::pi / 360);
    return (forward() + tangent * (aspect * x * right() + y * up())).normalized();
}

Vec3 OrbitCamera::inView(const Vec3& place) const {
    const Vec3 to = place - eye();
    return {to.dot(right()), to.dot(up()), to.dot(forward())};
}

Vec3 OrbitCamera::project(const Vec3& place, double aspect) const {
    const double tangent = std::tan(fieldOfView_ * std::numbers::pi / 360);
    const Vec3 seen = inView(place);
    const double scale = seen[2] > 0 ? 1 / (tangent * seen[2]) : 0;
    return {scale * seen[0] / aspect, scale * seen[1], seen[2]};
}

}  // namespace sunder::view
