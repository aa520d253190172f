#pragma once
#include "scene/scene.hpp"

namespace sunder::view {

/// A camera that turns around a point. Distances in m, angles in radians.
class OrbitCamera {
  public:
    explicit OrbitCamera(const CameraDescription& home) { setHome(home); }

    /// Where reset() goes; goes there.
    void setHome(const CameraDescription&);
    void reset() { setHome(home_); }

    /// Turns it by so many radians to the right and up, around its target.
    void orbit(double right, double up);
    /// Moves camera and target across the picture, in shares of its height: the wall follows the
    /// mouse.
    void pan(double right, double up);
    /// Nearer by this factor, or further where it is below 1.
    void zoom(double factor);
    /// Moves camera and target, m: forward and right on the level, and up.
    void move(double forward, double right, double up);

    CameraDescription description() const;
    /// Direction, of length 1, of what is seen at a place in the picture: x from −1 (left) to 1, y
    /// from −1 (bottom) to 1. `aspect` is width / height.
    Vec3 ray(double x, double y, double aspect) const;
    /// The opposite: x and y of a place in the picture, and its depth, m, along the view; not
    /// positive behind the camera, where x and y mean nothing.
    Vec3 project(const Vec3& place, double aspect) const;
    Vec3 forward() const;  ///< of length 1
    double distance() const { return distance_; }

  private:
    void keepNear();
    Vec3 right() const;
    Vec3 up() const { return right().cross(forward()); }

    CameraDescription home_;
    Vec3 target_{0, 0, 0};
    double distance_ = 1, yaw_ = 0, pitch_ = 0, fieldOfView_ = 45;
};

}  // namespace sunder::view
