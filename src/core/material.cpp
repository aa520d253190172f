#include "core/material.hpp"

#include "core/names.hpp"

namespace sunder::core {
namespace {

template <class Enum, std::size_t Count>
std::string_view nameAt(const std::string_view (&names)[Count], Enum value) {
    const auto index = static_cast<std::size_t>(value);
    return index < Count ? names[index] : std::string_view();
}

}  // namespace

std::string_view toString(ConstitutiveLaw law) {
    return nameAt(kLawNames, law);
}

std::string_view toString(FractureMode mode) {
    return nameAt(kFractureNames, mode);
}

std::string_view toString(ClusterKind kind) {
    return nameAt(kClusterNames, kind);
}

std::string_view toString(SurfaceKind kind) {
    return nameAt(kSurfaceNames, kind);
}

}  // namespace sunder::core
