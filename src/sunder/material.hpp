#pragma once
#include <sunder/export.h>
#include <sunder/types.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace sunder {

/// How stress follows from deformation.
enum class ConstitutiveLaw {
    Green,      ///< Green's strain, St. Venant–Kirchhoff: cheap, weak under strong compression.
    Corotated,  ///< Linear elasticity in each element's rotated frame.
};

/// What breaks a material (docs/fracture.md).
enum class FractureMode {
    None,  ///< Nothing does.
    Cell,  ///< A cell whose stress exceeds `maxStress` leaves all its neighbours.
    Bond,  ///< Faces between cells break by traction and damage.
};

/// How cells are grouped into chunks with weak boundaries.
enum class ClusterKind {
    None,         ///< They are not.
    Voronoi,      ///< Irregular chunks: concrete; stretched ones: glass.
    RunningBond,  ///< Bricks: rows along x, every other one shifted by half a brick.
    Planks,       ///< Strips side by side along x that run along y.
};

/// What Sunder's own pictures draw a surface as.
enum class SurfaceKind {
    Plain,     ///< One colour.
    Wood,      ///< Grain along y, growth rings across.
    Brick,     ///< Bricks and mortar where clusters have them.
    Concrete,  ///< Grey, with pores.
    Rubber,    ///< Smooth and dull.
    Glass,     ///< Smooth; `transparency` says how clear.
};

/// Everything that makes wood wood. Each field: unit, range, and what raising it does.
struct SUNDER_API Material {
    /// One of the materials that come with Sunder: see presetNames(). Fails with the list of them
    /// where there is none of this name. From any thread.
    static Result<Material> preset(std::string_view name);
    /// The names of all presets, in alphabetical order. From any thread.
    static std::vector<std::string> presetNames();
    /// What a material file says (docs/materials.md). `path`: with a '/' or ending in ".toml".
    /// Fails with the line of the first thing that is wrong. From any thread.
    static Result<Material> load(std::string_view path);

    std::string name{};  ///< For messages: one line of up to 1000 bytes of UTF-8, or empty.

    /// Young's modulus, Pa, 1 to 1e12. Stiffer. Limited by the substep; World::notes() then says
    /// so.
    double youngModulus = 1e7;
    /// Poisson's ratio, 0 to below 0.5. Bulges more sideways when squeezed; towards 0.5 the volume
    /// is kept.
    double poissonRatio = 0.3;
    /// kg/m³, 0.001 to 1e5. Heavier: waves are slower, a hit moves it less.
    double density = 1000;
    /// Drag, 1/s, 0 to 1e3. Motion dies out sooner, that of flying pieces too.
    double damping = 1;
    /// Factor on the world's gravity, −100 to 100.
    double gravity = 1;
    /// How stress follows from deformation.
    ConstitutiveLaw law = ConstitutiveLaw::Corotated;

    /// What breaks it.
    FractureMode fracture = FractureMode::Bond;
    /// FractureMode::Cell only: the largest principal stress a cell bears, Pa, above 0 to 1e15.
    double maxStress = 1e6;
    /// FractureMode::Bond: the traction at which a face with normal x, y or z starts to take
    /// damage, Pa, above 0 to 1e15. Wood is strong across faces with normal y, along its grain.
    Vec3 strength{1e6, 1e6, 1e6};
    /// The same of faces between two clusters. Lower: chunks come apart whole.
    Vec3 boundaryStrength{1e6, 1e6, 1e6};
    /// The length of material that a crack must overload before it opens, m, 1e-6 to 100. Longer:
    /// tougher, fewer small pieces.
    double damageLength = 1;
    /// Weight of shear beside tension, 0 to 10. Higher: shear breaks it, too.
    double shearWeight = 0.3;
    /// Internal friction, 0 to 10. Higher: faces that are pressed together hold better.
    double internalFriction = 0.3;
    /// Scatter of strengths from face to face, 0 to 1.
    double spread = 0;
    /// Wave length of a smooth variation of strength over space, m, 0 (none) to 100.
    double noiseLength = 0;
    /// Amplitude of that variation, 0 to 0.95.
    double noiseAmplitude = 0;
    /// How cells are grouped into chunks.
    ClusterKind clusters = ClusterKind::None;
    /// Mean size of a cluster along x, y, z, m, 0 to 1000; 0: they reach through the whole body
    /// along that axis. At least three cells wide works best.
    Vec3 clusterSize{0.4, 0.4, 0};

    /// Coulomb friction of piece on piece, 0 to 10; two materials take the mean. Higher: heaps
    /// stand steeper.
    double friction = 0.6;
    /// Restitution, 0 to 1: the share of their speed that pieces keep after a hit. Higher: they
    /// bounce.
    double restitution = 0.2;

    /// The length of a horizontal edge on which `horizEdgeFrequency` points come, m, 0.001 to 100.
    /// Smaller: finer splinters.
    double avgDisplaySectionWidth = 0.3;
    /// The same of a vertical edge, m, 0.001 to 100.
    double avgDisplaySectionHeight = 0.8;
    /// Corners of torn pieces lie at random by up to half of this each way, m, 0 to 100. Larger:
    /// less regular.
    double randDisplaySectionWidth = 0;
    /// The same upwards, m, 0 to 100.
    double randDisplaySectionHeight = 0;
    /// Points on a torn horizontal edge, 0 to 20. More: more splinters.
    double horizEdgeFrequency = 0;
    /// How far they zig-zag up and down, m, 0 to 100; at most 0.45 of a cell. Larger: longer
    /// splinters.
    double horizEdgeAmplitude = 0;
    /// Points on a torn vertical edge, 0 to 20.
    double vertEdgeFrequency = 0;
    /// How far they zig-zag sideways, m, 0 to 100.
    double vertEdgeAmplitude = 0;
    /// Mortar between bricks, groove between planks, m, 0 to 1. Wider.
    double jointWidth = 0;

    /// What Sunder's own pictures draw it as.
    SurfaceKind surface = SurfaceKind::Plain;
    /// Colour of the outside, linear RGB, each 0 to 1.
    Vec3 colour{0.6, 0.6, 0.6};
    /// Colour of what a break bares, linear RGB, each 0 to 1.
    Vec3 insideColour{0.7, 0.7, 0.7};
    /// 0 (opaque) to 1 (clear): the share of light that passes a face seen from straight in front.
    double transparency = 0;
};

}  // namespace sunder
