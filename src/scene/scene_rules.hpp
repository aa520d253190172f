#pragma once
#include <span>
#include <string_view>

#include "core/limits.hpp"
#include "core/rule.hpp"
#include "scene/scene.hpp"

namespace sunder::scene {

// Rules of what a scene file has beside the world (core/rules.hpp).

inline constexpr core::Rule<Scene> kFramesRule{
    "frames", {1, 1e6}, &Scene::frames, "How long `sunder run` runs, in frames of 1/60 s."};
inline constexpr core::Rule<Scene> kSubstepsRule{
    "substeps",
    {1, 10000},
    &Scene::substeps,
    "In 1/60 s. More: carries stiffer materials and faster hits, slower."};
/// What stands for a number of substeps that chooseSubsteps() finds.
inline constexpr std::string_view kAuto = "auto";
inline constexpr core::Rule<Scene> kMaxSubstepsRule{
    "max_substeps",
    {1, 10000},
    &Scene::maxSubsteps,
    "Where they are automatic, no more than that. Fewer: faster, and stiff materials are softer."};

inline constexpr core::Rule<CameraDescription> kCameraRules[] = {
    {"position",
     {-core::kMaxLength, core::kMaxLength, "m"},
     &CameraDescription::position,
     "Where it is."},
    {"target",
     {-core::kMaxLength, core::kMaxLength, "m"},
     &CameraDescription::target,
     "What it looks at, at least 0.001 m away."},
    {"field_of_view",
     {1, 170, "degrees"},
     &CameraDescription::fieldOfView,
     "From bottom to top. Larger: sees more, smaller."},
};

inline std::span<const core::Rule<CameraDescription>> cameraRules() {
    return kCameraRules;
}

/// Copies of a body.
struct CopiesDescription {
    core::IVec3 copies{1, 1, 1};  ///< along x, y, z
    core::Vec3 spacing{0, 0, 0};  ///< m, from one to the next
};
inline constexpr core::Rule<CopiesDescription> kCopiesRules[] = {
    {"copies",
     {1, static_cast<double>(core::kMaxBodies)},
     &CopiesDescription::copies,
     "How many there are along x, y, z."},
    {"spacing",
     {-core::kMaxLength, core::kMaxLength, "m"},
     &CopiesDescription::spacing,
     "The way from one copy to the next along x, y, z."},
};

inline std::span<const core::Rule<CopiesDescription>> copiesRules() {
    return kCopiesRules;
}

/// How an object is turned, and a body.
struct RotationDescription {
    core::Vec3 rotation{0, 0, 0};  ///< degrees about the world's x axis, then y, then z
};
inline constexpr core::Rule<RotationDescription> kRotationRule{
    "rotation",
    {-360, 360, "degrees"},
    &RotationDescription::rotation,
    "Angles about the world's x axis, then y, then z."};

}  // namespace sunder::scene
