#pragma once
#include <optional>

#include "scene/scene.hpp"

namespace sunder::view {

/// A camera that turns around a point. Distances in m, angles in radians. Where there is ground, at
/// y = 0, its eye stays above it and it looks at nothing below: it turns along the ground, and is
/// lifted where a scene has it lower.
class OrbitCamera {
  public:
    /// `clearance`: of the eye above the ground; none: there is no ground.
    explicit OrbitCamera(const scene::CameraDescription& home,
                         std::optional<double> clearance = {}) {
        setHome(home, clearance);
    }

    /// Goes there.
    void setHome(const scene::CameraDescription&, std::optional<double> clearance = {});
    /// Of the world as it is from now on.
    void setClearance(std::optional<double>);
    /// Since setHome(), by one of the following.
    bool moved() const { return moved_; }

    /// Turns it by so many radians to the right and up, around its target.
    void orbit(double right, double up);
    /// Moves camera and target across the picture, in shares of its height: the wall follows the
    /// mouse.
    void pan(double right, double up);
    /// Nearer by this factor, or further where it is below 1.
    void zoom(double factor);
    /// Moves camera and target, m: forward and right on the level, and up.
    void move(double forward, double right, double up);

    scene::CameraDescription description() const;
    /// Direction, of length 1, of what is seen at a place in the picture: x from −1 (left) to 1, y
    /// from −1 (bottom) to 1. `aspect` is width / height.
    core::Vec3 ray(double x, double y, double aspect) const;
    /// The opposite: x and y of a place in the picture, and its depth, m, along the view; not
    /// positive behind the camera, where x and y mean nothing.
    core::Vec3 project(const core::Vec3& place, double aspect) const;
    /// m, to the right, up and ahead of the eye.
    core::Vec3 inView(const core::Vec3& place) const;
    core::Vec3 forward() const;  ///< of length 1
    double distance() const { return distance_; }

  private:
    void keepNear();
    void keepAbove();
    /// Pitch at which the eye is as low as it may be.
    double lowest() const;
    core::Vec3 eye() const { return target_ - distance_ * forward(); }
    core::Vec3 right() const;
    core::Vec3 up() const { return right().cross(forward()); }

    std::optional<double> clearance_;
    bool moved_ = false;
    core::Vec3 target_{0, 0, 0};
    double distance_ = 1, yaw_ = 0, pitch_ = 0, fieldOfView_ = 45;
};

}  // namespace sunder::view
