#include "core/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/description.hpp"

namespace sunder::core {

Mat3 axesOf(const Eigen::Quaterniond& orientation) {
    const auto exact = [](double x) {
        const double whole = std::round(x);
        return std::abs(x - whole) < 1e-14 ? whole + 0.0 : x;  // and no negative zero
    };
    return orientation.toRotationMatrix().unaryExpr(exact);
}

bool isUpright(const Mat3& axes) {
    return axes == Mat3::Identity();
}

Vec3 originOf(const BodyDescription& body) {
    const Vec3 corner(body.size[0] / 2, 0, body.size[2] / 2);
    return body.position - axesOf(body.orientation) * corner;
}

Eigen::Quaterniond fromDegrees(const Vec3& degrees) {
    const Vec3 angle = degrees * std::numbers::pi / 180;
    return Eigen::AngleAxisd(angle[2], Vec3::UnitZ()) * Eigen::AngleAxisd(angle[1], Vec3::UnitY()) *
           Eigen::AngleAxisd(angle[0], Vec3::UnitX());
}

Vec3 toDegrees(const Eigen::Quaterniond& orientation) {
    const Mat3 R = orientation.toRotationMatrix();
    const double level = std::hypot(R(0, 0), R(1, 0));
    const double y = std::atan2(-R(2, 0), level);
    // Where the first and the last axis have become one, a turn about the last has it all.
    const bool locked = level < 1e-8;
    const double x = locked ? 0 : std::atan2(R(2, 1), R(2, 2));
    const double z = locked ? std::atan2(-R(0, 1), R(1, 1)) : std::atan2(R(1, 0), R(0, 0));
    const Vec3 degrees = Vec3(x, y, z) * 180 / std::numbers::pi;
    // What a person wrote, and not 29.999999999999996 for 30: nothing drifts from save to save.
    const Vec3 rounded =
        degrees.unaryExpr([](double d) { return std::round(d * 1e9) / 1e9 + 0.0; });
    const Eigen::Vector4d written = fromDegrees(rounded).coeffs(), given = orientation.coeffs();
    const double apart = std::min((written - given).norm(), (written + given).norm());
    return apart < 1e-15 ? rounded : degrees;
}

}  // namespace sunder::core
