#include "view/orbit_camera.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace sunder::view {
namespace {

/// Just short of straight up or down, where "up" would flip.
constexpr double kSteepest = 1.55;
constexpr double kNearest = 0.05, kFarthest = 1000;  // m

}  // namespace

void OrbitCamera::setHome(const CameraDescription& home) {
    home_ = home;
    const Vec3 back = home.position - home.target;
    target_ = home.target;
    distance_ = std::clamp(back.norm(), kNearest, kFarthest);
    yaw_ = std::atan2(back[0], back[2]);
    pitch_ = std::clamp(std::asin(std::clamp(back[1] / std::max(back.norm(), 1e-9), -1., 1.)),
                        -kSteepest, kSteepest);
    fieldOfView_ = home.fieldOfView;
}

Vec3 OrbitCamera::forward() const {
    return -Vec3(std::sin(yaw_) * std::cos(pitch_), std::sin(pitch_),
                 std::cos(yaw_) * std::cos(pitch_));
}

Vec3 OrbitCamera::right() const {
    return Vec3(std::cos(yaw_), 0, -std::sin(yaw_));
}

void OrbitCamera::orbit(double toTheRight, double upwards) {
    yaw_ = std::remainder(yaw_ + toTheRight, 2 * std::numbers::pi);
    pitch_ = std::clamp(pitch_ + upwards, -kSteepest, kSteepest);
}

void OrbitCamera::pan(double toTheRight, double upwards) {
    const double height = 2 * distance_ * std::tan(fieldOfView_ * std::numbers::pi / 360);
    target_ -= height * (toTheRight * right() + upwards * up());
    keepNear();
}

void OrbitCamera::zoom(double factor) {
    distance_ = std::clamp(distance_ / factor, kNearest, kFarthest);
}

void OrbitCamera::move(double ahead, double toTheRight, double upwards) {
    const Vec3 level(-std::sin(yaw_), 0, -std::cos(yaw_));
    target_ += ahead * level + toTheRight * right() + upwards * Vec3(0, 1, 0);
    keepNear();
}

/// A scene's file has bounds for its camera, too.
void OrbitCamera::keepNear() {
    target_ = target_.cwiseMax(-kFarthest).cwiseMin(kFarthest);
}

CameraDescription OrbitCamera::description() const {
    return {target_ - distance_ * forward(), target_, fieldOfView_};
}

Vec3 OrbitCamera::ray(double x, double y, double aspect) const {
    const double tangent = std::tan(fieldOfView_ * std::numbers::pi / 360);
    return (forward() + tangent * (aspect * x * right() + y * up())).normalized();
}

Vec3 OrbitCamera::project(const Vec3& place, double aspect) const {
    const double tangent = std::tan(fieldOfView_ * std::numbers::pi / 360);
    const Vec3 to = place - (target_ - distance_ * forward());
    const double depth = to.dot(forward());
    const double scale = depth > 0 ? 1 / (tangent * depth) : 0;
    return {scale * to.dot(right()) / aspect, scale * to.dot(up()), depth};
}

}  // namespace sunder::view
