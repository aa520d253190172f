#include "core/material.hpp"

namespace sunder::core {
namespace {

using M = Material;

// key, unit, min, max, min excluded, max excluded, scalar, vector, help
constexpr MaterialField kFields[] = {
    {"young_modulus", "Pa", 1, 1e12, false, false, &M::youngModulus, nullptr,
     "Stiffness. Higher: bends less and rings faster; more than a step can carry is limited, and "
     "said so."},
    {"poisson_ratio", "1", 0, 0.5, false, true, &M::poissonRatio, nullptr,
     "How much it bulges sideways when squeezed. Towards 0.5 it keeps its volume."},
    {"density", "kg/m³", 0.001, 1e5, false, false, &M::density, nullptr,
     "Mass per volume. Higher: slower waves, and the same push moves it less."},
    {"damping", "1/s", 0, 1e3, false, false, &M::damping, nullptr,
     "Drag. Higher: swinging and flying pieces lose speed sooner."},
    {"gravity", "1", -100, 100, false, false, &M::gravity, nullptr,
     "Factor on the scene's gravity. 0 floats, negative rises."},
    {"max_stress", "Pa", 0, 1e15, true, false, &M::maxStress, nullptr,
     "Stress at which a cell leaves all its neighbours, where fracture is 'cell'. Higher: harder "
     "to break."},
    {"strength", "Pa", 0, 1e15, true, false, nullptr, &M::strength,
     "Traction at which faces with normal x, y, z start to take damage, where fracture is 'bond'. "
     "Higher: harder to break."},
    {"boundary_strength", "Pa", 0, 1e15, true, false, nullptr, &M::boundaryStrength,
     "The same between two chunks. Lower: chunks come apart whole."},
    {"damage_length", "m", 1e-6, 100, false, false, &M::damageLength, nullptr,
     "Length of material that a crack must overload before it opens. Longer: tougher, less dust."},
    {"shear_weight", "1", 0, 10, false, false, &M::shearWeight, nullptr,
     "How much shear counts beside pull. Higher: sliding breaks it too."},
    {"internal_friction", "1", 0, 10, false, false, &M::internalFriction, nullptr,
     "How well pressed faces hold against shear. Higher: they hold better."},
    {"friction", "1", 0, 10, false, false, &M::friction, nullptr,
     "Friction between pieces. Higher: heaps stand steeper."},
    {"restitution", "1", 0, 1, false, false, &M::restitution, nullptr,
     "Share of speed that is kept after a hit. Higher: pieces bounce."},
    {"spread", "1", 0, 1, false, false, &M::spread, nullptr,
     "Scatter of strength from face to face. Higher: cracks wander."},
    {"noise_length", "m", 0, 100, false, false, &M::noiseLength, nullptr,
     "Wave length of strong and weak zones. 0: none."},
    {"noise_amplitude", "1", 0, 0.95, false, false, &M::noiseAmplitude, nullptr,
     "How much strong and weak zones differ."},
    {"cluster_size", "m", 0, 1000, false, false, nullptr, &M::clusterSize,
     "Mean size of a chunk along x, y, z. 0: it reaches through the whole wall."},
    {"avg_display_section_width", "m", 0.001, 100, false, false, &M::avgDisplaySectionWidth,
     nullptr, "Width of a visible section, before chance is added."},
    {"avg_display_section_height", "m", 0.001, 100, false, false, &M::avgDisplaySectionHeight,
     nullptr, "Height of a visible section, before chance is added."},
    {"rand_display_section_width", "m", 0, 100, false, false, &M::randDisplaySectionWidth, nullptr,
     "Chance added to the width. Higher: sections differ more."},
    {"rand_display_section_height", "m", 0, 100, false, false, &M::randDisplaySectionHeight,
     nullptr, "Chance added to the height. Higher: sections differ more."},
    {"horiz_edge_frequency", "1", 0, 20, false, false, &M::horizEdgeFrequency, nullptr,
     "Points added to a level torn edge. More: finer splinters."},
    {"horiz_edge_amplitude", "m", 0, 100, false, false, &M::horizEdgeAmplitude, nullptr,
     "How far level torn edges zig-zag."},
    {"vert_edge_frequency", "1", 0, 20, false, false, &M::vertEdgeFrequency, nullptr,
     "Points added to an upright torn edge. More: finer splinters."},
    {"vert_edge_amplitude", "m", 0, 100, false, false, &M::vertEdgeAmplitude, nullptr,
     "How far upright torn edges zig-zag."},
    {"joint_width", "m", 0, 1, false, false, &M::jointWidth, nullptr,
     "Mortar between bricks, groove between planks; broken edges stay within it."},
    {"colour", "1", 0, 1, false, false, nullptr, &M::colour,
     "Colour of the outside, linear red, green, blue."},
    {"inside_colour", "1", 0, 1, false, false, nullptr, &M::insideColour,
     "Colour of what a break bares, linear red, green, blue."},
    {"transparency", "1", 0, 1, false, false, &M::transparency, nullptr,
     "Share of light that passes straight through a face. 0: opaque."},
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

}  // namespace sunder::core
