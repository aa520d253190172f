#pragma once
#include <Eigen/Geometry>

#include "core/types.hpp"

namespace sunder::core {

struct BodyDescription;

/// A body's own axes in the world, as columns, of a quaternion of length 1. What is within 1e-14
/// of 0, 1 or −1 is that, so that quarter turns are exact, whatever angles they were made of.
Mat3 axesOf(const Eigen::Quaterniond& orientation);

/// Whether the body's own axes are the world's, to the bit.
bool isUpright(const Mat3& axes);

/// m, in the world: the corner of a body that lies lowest along its own axes.
Vec3 originOf(const BodyDescription&);

/// The angles by which files describe an orientation: degrees about the world's x axis, then y,
/// then z.
Eigen::Quaterniond fromDegrees(const Vec3& degrees);
/// The inverse: the first and last from −180 to 180, the middle one from −90 to 90. Exactly zero
/// of the identity.
Vec3 toDegrees(const Eigen::Quaterniond&);

}  // namespace sunder::core
