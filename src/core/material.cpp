#include "core/material.hpp"

namespace sunder {
namespace {

using M = Material;

// key, unit, min, max, min excluded, max excluded, scalar, vector
constexpr MaterialField kFields[] = {
    {"young_modulus", "Pa", 1, 1e12, false, false, &M::youngModulus, nullptr},
    {"poisson_ratio", "1", 0, 0.5, false, true, &M::poissonRatio, nullptr},
    {"density", "kg/m³", 0.001, 1e5, false, false, &M::density, nullptr},
    {"damping", "1/s", 0, 1e3, false, false, &M::damping, nullptr},
    {"gravity", "1", -100, 100, false, false, &M::gravity, nullptr},
    {"max_stress", "Pa", 0, 1e15, true, false, &M::maxStress, nullptr},
    {"strength", "Pa", 0, 1e15, true, false, nullptr, &M::strength},
    {"boundary_strength", "Pa", 0, 1e15, true, false, nullptr, &M::boundaryStrength},
    {"damage_length", "m", 1e-6, 100, false, false, &M::damageLength, nullptr},
    {"shear_weight", "1", 0, 10, false, false, &M::shearWeight, nullptr},
    {"internal_friction", "1", 0, 10, false, false, &M::internalFriction, nullptr},
    {"friction", "1", 0, 10, false, false, &M::friction, nullptr},
    {"restitution", "1", 0, 1, false, false, &M::restitution, nullptr},
    {"spread", "1", 0, 1, false, false, &M::spread, nullptr},
    {"noise_length", "m", 0, 100, false, false, &M::noiseLength, nullptr},
    {"noise_amplitude", "1", 0, 0.95, false, false, &M::noiseAmplitude, nullptr},
    {"cluster_size", "m", 0, 1000, false, false, nullptr, &M::clusterSize},
    {"avg_display_section_width", "m", 0.001, 100, false, false, &M::avgDisplaySectionWidth,
     nullptr},
    {"avg_display_section_height", "m", 0.001, 100, false, false, &M::avgDisplaySectionHeight,
     nullptr},
    {"rand_display_section_width", "m", 0, 100, false, false, &M::randDisplaySectionWidth, nullptr},
    {"rand_display_section_height", "m", 0, 100, false, false, &M::randDisplaySectionHeight,
     nullptr},
    {"horiz_edge_frequency", "1", 0, 20, false, false, &M::horizEdgeFrequency, nullptr},
    {"horiz_edge_amplitude", "m", 0, 100, false, false, &M::horizEdgeAmplitude, nullptr},
    {"vert_edge_frequency", "1", 0, 20, false, false, &M::vertEdgeFrequency, nullptr},
    {"vert_edge_amplitude", "m", 0, 100, false, false, &M::vertEdgeAmplitude, nullptr},
    {"joint_width", "m", 0, 1, false, false, &M::jointWidth, nullptr},
    {"colour", "1", 0, 1, false, false, nullptr, &M::colour},
    {"inside_colour", "1", 0, 1, false, false, nullptr, &M::insideColour},
    {"transparency", "1", 0, 1, false, false, &M::transparency, nullptr},
};

}  // namespace

std::span<const MaterialField> materialFields() {
    return kFields;
}

std::string_view toString(ConstitutiveLaw law) {
    return law == ConstitutiveLaw::Green ? "green" : "corotated";
}

std::string_view toString(FractureMode mode) {
    switch (mode) {
        case FractureMode::None:
            return "none";
        case FractureMode::Cell:
            return "cell";
        case FractureMode::Bond:
            return "bond";
    }
    return "";
}

std::string_view toString(ClusterKind kind) {
    switch (kind) {
        case ClusterKind::None:
            return "none";
        case ClusterKind::Voronoi:
            return "voronoi";
        case ClusterKind::RunningBond:
            return "running-bond";
        case ClusterKind::Planks:
            return "planks";
    }
    return "";
}

std::string_view toString(SurfaceKind kind) {
    switch (kind) {
        case SurfaceKind::Plain:
            return "plain";
        case SurfaceKind::Wood:
            return "wood";
        case SurfaceKind::Brick:
            return "brick";
        case SurfaceKind::Concrete:
            return "concrete";
        case SurfaceKind::Rubber:
            return "rubber";
        case SurfaceKind::Glass:
            return "glass";
    }
    return "";
}

}  // namespace sunder
