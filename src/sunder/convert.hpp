#pragma once
#include "core/world.hpp"
#include "sunder/sunder.hpp"

// Between the public interface and the inside. Not installed.

namespace sunder {

inline core::Vec3 toCore(const Vec3& v) {
    return {v.x, v.y, v.z};
}
inline core::IVec3 toCore(const IVec3& v) {
    return {v.x, v.y, v.z};
}
inline Vec3 fromCore(const core::Vec3& v) {
    return {v[0], v[1], v[2]};
}
inline IVec3 fromCore(const core::IVec3& v) {
    return {v[0], v[1], v[2]};
}
/// Throws InputError, beginning with `what`, unless its length is 1 within 1e-3.
Eigen::Quaterniond toCore(const Quat&, const char* what);
Quat fromCore(const Eigen::Quaterniond&);

core::Material toCore(const Material&);
Material fromCore(const core::Material&);

/// Throws InputError where a push is of several kinds.
core::EventDescription toCore(const Push&, const std::vector<core::BodyDescription>& bodies);

/// Throws InputError for what cannot be told to the inside; core/check.hpp refuses the rest.
core::WorldDescription toCore(const WorldDesc&);
WorldDesc fromCore(const core::WorldDescription&);

ObjectState fromCore(const core::ObjectState&, const core::Object&);

}  // namespace sunder
