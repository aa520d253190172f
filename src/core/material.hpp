#pragma once
#include <string>
#include <string_view>

#include "core/types.hpp"

namespace sunder::core {

/// How stress follows from the deformation gradient.
enum class ConstitutiveLaw {
    Green,      ///< the thesis: Green's strain (eq. 2.2), St. Venant–Kirchhoff
    Corotated,  ///< linear elasticity in the element's rotated frame; survives strong compression
};

/// What breaks the material (docs/fracture.md).
enum class FractureMode {
    None,
    Cell,  ///< the thesis: a cell whose stress exceeds maxStress leaves all its neighbours
    Bond,  ///< faces between cells break by traction and damage
};

/// How cells are grouped into chunks with weak boundaries.
enum class ClusterKind {
    None,
    Voronoi,      ///< irregular chunks (concrete; stretched: glass)
    RunningBond,  ///< bricks: rows along x, every other one shifted by half a brick
    Planks,       ///< strips side by side along x, running along y
};

/// What a material's surface is drawn as (src/render, glsl/draw/surface.glsl).
enum class SurfaceKind {
    Plain,  ///< one colour
    Wood,   ///< grain along y, growth rings across
    Brick,  ///< bricks and mortar where `clusters` has them
    Concrete,
    Rubber,
    Glass,  ///< smooth; `transparency` says how clear
};

/// Everything that makes wood wood. Each field: unit, range, what raising it does. The ranges stand
/// in materialRules() (core/rules.hpp), for readers, sliders and the check of a world.
struct Material {
    std::string name;         ///< for messages and files; one line of up to 1000 bytes, or empty
    std::string description;  ///< likewise

    // --- Elasticity (thesis, chapter 6) ---
    /// Young's modulus, Pa, 1 to 1e12. Stiffer; limited by the step (stableYoungModulus), never
    /// silently.
    double youngModulus = 1e7;
    /// Poisson's ratio, 1, 0 ≤ ν < 0.5. Bulges more sideways when squeezed; towards 0.5 volume is
    /// kept.
    double poissonRatio = 0.3;
    /// Density, kg/m³, 0.001 to 1e5. Heavier: slower waves, a hit moves it less.
    double density = 1000;
    /// Drag, 1/s, 0 to 1e3: v ← v·exp(−d·h). Motion dies out sooner, flight too. A body of several
    /// materials takes the mass-weighted mean of its cells.
    double damping = 1;
    /// Factor on the scene's gravity, 1, −100 to 100 (the thesis's `gravity`). Mass-weighted mean
    /// within a body.
    double gravity = 1;
    ConstitutiveLaw law = ConstitutiveLaw::Corotated;

    // --- Fracture ---
    FractureMode fracture = FractureMode::Bond;
    /// `cell` only: largest principal Cauchy stress a cell bears, Pa, > 0 to 1e15. Harder to break.
    double maxStress = 1e6;
    /// `bond`: equivalent traction at which a face with normal x, y, z starts to take damage, Pa, >
    /// 0 to 1e15. Wood is strong across faces with normal y (along its grain).
    Vec3 strength{1e6, 1e6, 1e6};
    /// `bond`: the same for faces on the boundary of two clusters. Lower: chunks come apart whole.
    Vec3 boundaryStrength{1e6, 1e6, 1e6};
    /// Length of material a crack must overload before it opens, m, 1e-6 to 100. Longer: tougher,
    /// fewer dust cells.
    double damageLength = 1;
    /// Weight β of shear in the equivalent traction, 1, 0 to 10. Higher: shear breaks it too.
    double shearWeight = 0.3;
    /// Internal friction μ, 1, 0 to 10: compression on a face holds shear back. Higher: pressed
    /// faces hold better.
    double internalFriction = 0.3;
    /// Scatter of strengths from face to face, 1, 0 to 1 (Weibull of mean 1 and modulus 1.2/spread,
    /// kept in 0.25 to 3).
    double spread = 0;
    /// Smooth variation of strength over space: its wave length, m, 0 (none) to 100, and amplitude,
    /// 1, 0 to 0.95.
    double noiseLength = 0;
    double noiseAmplitude = 0;
    ClusterKind clusters = ClusterKind::None;
    /// Mean size of a cluster along x, y, z, m, 0 to 1000; 0: clusters reach through the whole body
    /// along that axis. Keep it at least three cells wide. Planks use x.
    Vec3 clusterSize{0.4, 0.4, 0};

    // --- Contact (core/contact.hpp) ---
    /// Coulomb friction μ of piece on piece, 1, 0 to 10; two materials take the mean. Higher: heaps
    /// stand steeper.
    double friction = 0.6;
    /// Restitution e, 1, 0 to 1: share of the speed that two cells keep after a hit, from 0.19 up.
    /// Higher: pieces bounce.
    double restitution = 0.2;

    // --- Display mesh (thesis, chapter 8; surface/display_lattice.hpp): a section per cell ---
    /// m, 0.001 to 100. On this length of a horizontal (width) or vertical (height) edge come the
    /// edge points below; the size of the cells, as in the thesis: on each section's edge. Smaller:
    /// finer splinters.
    double avgDisplaySectionWidth = 0.3;
    double avgDisplaySectionHeight = 0.8;
    /// m, 0 to 100. Corners of sections move at random by up to half of this each way, and by less
    /// where cells are small. Larger: less regular.
    double randDisplaySectionWidth = 0;
    double randDisplaySectionHeight = 0;
    /// 1, 0 to 20, rounded: points on a horizontal edge, and how far they zig-zag up and down, m, 0
    /// to 100, at most 0.45 of a cell. More, longer: more splinters, longer ones.
    double horizEdgeFrequency = 0;
    double horizEdgeAmplitude = 0;
    /// The same on vertical edges, sideways.
    double vertEdgeFrequency = 0;
    double vertEdgeAmplitude = 0;
    /// m, 0 to 1: mortar between bricks, groove between planks. Broken edges along a boundary of
    /// running-bond or planks stay within it, however large the amplitudes.
    double jointWidth = 0;

    // --- Look ---
    SurfaceKind surface = SurfaceKind::Plain;
    /// Base colour of the outside and of what a break bares, linear RGB, each 0 to 1.
    Vec3 colour{0.6, 0.6, 0.6};
    Vec3 insideColour{0.7, 0.7, 0.7};
    /// 1, 0 (opaque) to 1 (clear): share of light that passes a face seen from straight in front.
    double transparency = 0;
};

/// "green", "corotated", …; empty: it has no such value.
std::string_view toString(ConstitutiveLaw);
std::string_view toString(FractureMode);
std::string_view toString(ClusterKind);
std::string_view toString(SurfaceKind);

}  // namespace sunder::core
