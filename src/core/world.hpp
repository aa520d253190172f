#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/material.hpp"
#include "core/object.hpp"
#include "core/overlap.hpp"
#include "core/types.hpp"

namespace sunder {

/// Corners of a cell: bit 0, 1, 2 of the corner's number is set on its +x, +y, +z side. Node =
/// 8·cell + corner.
inline constexpr int kCorners = 8;
inline constexpr int kTetrahedraPerCell = 5;
/// A cell owns the bonds through its +x, +y and +z faces. Bond = 3·cell + axis.
inline constexpr int kBondsPerCell = 3;
/// Damage of a bond that never was: no neighbour on that side. A bond holds while its damage is
/// below 1.
inline constexpr double kNoBond = 2;
/// Material constants of one cell come from a table of this many rows at most (one uniform block).
inline constexpr int kMaxElementLaws = 256;
/// Node indices and texel addresses stay exact in 32 bits up to here.
inline constexpr std::int64_t kMaxCells = 1 << 24;

/// Sides of a body, seen from +z: left/right are −x/+x, bottom/top −y/+y, back/front −z/+z.
enum class Side : std::uint8_t { Left, Right, Bottom, Top, Back, Front };

/// Replaces the material of a box of cells, or removes them.
struct RegionDescription {
    IVec3 from{0, 0, 0};  ///< first cell
    IVec3 to{0, 0, 0};    ///< last cell, inclusive
    int material = -1;    ///< index into WorldDescription::materials, or −1: no cells here
};

/// A block of cells on one lattice, as a scene file gives it.
struct BodyDescription {
    std::string name;
    Vec3 size{1, 1, 1};      ///< m
    IVec3 cells{1, 1, 1};    ///< cells along x, y, z
    Vec3 position{0, 0, 0};  ///< m, centre of the bottom face
    int material = 0;        ///< index into WorldDescription::materials
    std::vector<Side> anchors;
    std::vector<RegionDescription> regions;
    bool mayOverlap = false;  ///< when the world begins (core/overlap.hpp)
    std::string where;        ///< for error messages, for example "wood.toml:31: body 1: position"
};

/// Something that pushes a patch of a body for a while. All nodes whose rest position lies within
/// `radius` of `point` get the same acceleration.
struct EventDescription {
    enum class Kind {
        Impulse,   ///< vector is the whole momentum given to the patch, N·s
        Force,     ///< vector is the whole force on the patch, N
        Velocity,  ///< vector is the change of velocity of the patch were it free, m/s
    };
    double time = 0;  ///< s
    double duration =
        5e-3;  ///< s; an impulse is spread evenly over it (0.005 by default: less dust)
    Kind kind = Kind::Impulse;
    int body = 0;
    Vec3 point{0, 0, 0};  ///< m, relative to the body's position
    double radius = 0.1;  ///< m
    Vec3 vector{0, 0, 0};
    std::string where;  ///< for error messages, for example "wood.toml:31: event 1"
};

/// Four walls, upright without end, that nothing passes (core/room.hpp). The floor is the ground's.
struct RoomDescription {
    std::array<double, 2> x{-4, 4}, z{-3, 3};  ///< m, where the walls stand: low, high
    double friction = 0.6;                     ///< Coulomb coefficient, 1, 0 to 10
    std::optional<double> ceiling;             ///< m, its height
};

/// What a scene file says about the world, checked field by field but not yet laid out as cells and
/// nodes.
struct WorldDescription {
    std::vector<Material> materials;
    std::vector<BodyDescription> bodies;
    std::vector<EventDescription> events;
    std::vector<ObjectDescription> objects;  ///< need contact
    std::vector<ThrowDescription> throws;
    Vec3 gravity{0, -9.81, 0};    ///< m/s²
    bool ground = true;           ///< a floor at y = 0
    double groundFriction = 0.6;  ///< Coulomb coefficient, 1, 0 to 10
    std::optional<RoomDescription> room;
    bool contact = false;  ///< whether cells push each other (core/contact.hpp)
    /// m/s, 0.2 to 100 (slower is rest): what overlaps, and did not come to by a hit, parts no
    /// faster (core/overlap.hpp).
    double partingSpeed = 1;
    double step = 1.0 / 3000;  ///< s, one substep
    int fractureInterval = 4;  ///< substeps from one fracture update to the next, 1 to 100
    std::uint64_t seed = 1;    ///< of the strength map
};

struct Body {
    std::string name;
    IVec3 cells;
    Vec3 cellSize;  ///< m
    Vec3 origin;    ///< m, the corner with the smallest coordinates
    int firstCell = 0;
    double drag = 0;  ///< 1/s, mass-weighted mean of its cells' `damping`
    Vec3 gravity{0, 0,
                 0};  ///< m/s², the scene's times the mass-weighted mean of its cells' `gravity`
    int firstEvent = 0, eventCount = 0;
    double calmest = std::numeric_limits<double>::infinity();  ///< m/s: see core/sleep.hpp

    int cellCount() const { return cells.prod(); }
    /// World-wide index of the cell at lattice coordinates c (must lie inside).
    int cellAt(const IVec3& c) const {
        return firstCell + c[0] + cells[0] * (c[1] + cells[1] * c[2]);
    }
    IVec3 coordinates(int cell) const;
    bool contains(const IVec3& c) const;
};

/// A material too stiff for the step is made softer, and so slower: cracks in it keep pace with its
/// waves, not with what hits it. A blow that adds a traction which strains it by this much, and
/// that in the material itself would be kSuddenStress times the strength, breaks a bond at once.
inline constexpr double kSuddenStrain = 0.5;
inline constexpr double kSuddenStress = 5;

/// Constants of one material on cells of one size at the world's step: what an element needs to
/// turn strain into stress.
struct ElementLaw {
    int material = 0;
    Vec3 cellSize{1, 1, 1};
    double youngModulus = 0;    ///< Pa, E_eff: not more than the step can carry
    bool limited = false;       ///< E_eff < the material's
    double lambda = 0, mu = 0;  ///< Pa, Lamé parameters of E_eff
    double stressScale = 1;     ///< S = √(E/E_eff): what an impact's stress lost to the limit
    double damageTime = 1;      ///< s, τ = ℓ_d/√(E_eff/ρ)
    double maxStress = 0;       ///< Pa; infinite unless fracture = cell
    double suddenTraction = 0;  ///< Pa, kSuddenStrain·E_eff; infinite unless E is limited
    double restitution = 0;     ///< of the material, rounded to 1/255: what objects bounce with
    double contactDamping = 0;  ///< α of core/contact.hpp, from the material's restitution
    double hotViscosity = 0;    ///< Pa·s, of strongly deformed elements (core/elasticity.hpp)
    double largestStress = std::numeric_limits<double>::infinity();  ///< Pa, |P| by Green's law
};

/// Up to here a spring of the lighter cell's mass carries a few layers of the heavier ones.
inline constexpr double kUnequal = 8;

struct Event {
    int body;
    Eigen::Vector3f
        point;  ///< m, world; single precision so that every solver picks the same nodes
    float radius;
    Vec3 acceleration;  ///< m/s²
    double start, end;  ///< in steps, fractions count
    /// Share of step number `step` that lies inside [start, end], 0 to 1.
    double weight(std::int64_t step) const;
};

/// An object that is thrown as step number `step` begins.
struct Throw {
    std::int64_t step = 0;
    int object = 0;
    ObjectState state;
};

/// Whether a node is in an event's patch. The same single-precision operations in the same order as
/// glsl/physics/events.glsl.
bool insidePatch(const Event&, const Eigen::Vector3f& rest);

/// The state a solver advances. Doubles hold every solver's values without loss.
struct State {
    std::int64_t step = 0;
    std::vector<Vec3> displacement;  ///< m, per node, from rest
    std::vector<Vec3> velocity;      ///< m/s, per node
    std::vector<double>
        damage;                ///< per bond; holds below 1, never decreases; kNoBond: no neighbour
    std::vector<double> slow;  ///< Pa, per bond: slow part of its traction
    /// Pa, per cell: slow part of its largest principal stress; 0 unless it breaks by that
    /// (`fracture = "cell"`) and its stiffness is limited.
    std::vector<double> slowStress;
    std::vector<ObjectState> objects;
};

/// Bodies laid out as cells, nodes and bonds: everything that does not change while time runs.
/// Cells of all bodies share one numbering, dense within a body (x fastest), so neighbours follow
/// from the lattice.
class World {
  public:
    /// Throws InputError when something is too large, empty or contradictory, or in something else.
    explicit World(WorldDescription);

    const WorldDescription& description() const { return description_; }
    const std::vector<Body>& bodies() const { return bodies_; }
    const std::vector<ElementLaw>& laws() const { return laws_; }
    const std::vector<Event>& events() const { return events_; }  ///< sorted by body
    const std::vector<Object>& objects() const { return objects_; }
    const std::vector<Throw>& throws() const { return throws_; }  ///< in order of time
    /// Bodies that overlap as the world begins, by a, then b.
    const std::vector<Parting>& partings() const { return partings_; }
    /// Of these two bodies; null: they do not.
    const Parting* parting(int bodyA, int bodyB) const;
    double step() const { return description_.step; }
    double pushSpeed() const { return kPushShare * description_.partingSpeed; }  ///< U, m/s

    int cellCount() const { return static_cast<int>(cellBody_.size()); }
    int nodeCount() const { return kCorners * cellCount(); }
    int bondSlots() const { return kBondsPerCell * cellCount(); }
    int presentCells() const { return presentCells_; }
    /// Whether cells that may touch are so unequal that contact has to take in what the lighter
    /// ones bear (core/contact.hpp): some have more than kUnequal times the mass of others.
    bool unequalCells() const { return unequalCells_; }
    int bondCount() const { return bondCount_; }

    /// False for cells a region removed.
    bool present(int cell) const { return cellLaw_[cell] >= 0; }
    int bodyOf(int cell) const { return cellBody_[cell]; }
    /// Row of laws(), or −1 for an absent cell.
    int lawOf(int cell) const { return cellLaw_[cell]; }
    const Material& materialOf(int cell) const;  ///< of a present cell
    /// A body's own seed, so that fifty copies of a wall break in fifty ways.
    std::uint64_t bodySeed(int body) const;
    /// 0 or 1: which of the two mirrored splits into tetrahedra (parity of i+j+k).
    int parity(int cell) const;
    /// Cell next to this one along axis (0..2) in direction ±1, or −1 when there is none.
    int neighbour(int cell, int axis, int direction) const;

    /// m. A single-precision number, so that every solver has the same, and equal to the bit for
    /// all copies of a lattice point.
    Vec3 restPosition(int node) const;
    /// m, from the cell's corner 0 at rest; not rounded, so the shape of a cell does not depend on
    /// where it stands.
    Vec3 cornerOffset(int cell, int corner) const;
    double nodeMass(int node) const {
        return nodeMass_[node];
    }  ///< kg, of this copy alone; 0 where the cell is absent
    /// kg, of a present cell.
    double cellMass(int cell) const { return kCorners * nodeMass_[kCorners * cell]; }
    bool anchored(int node) const { return anchored_[node] != 0; }
    /// Pa; infinite where nothing but whole-cell fracture can break the bond.
    float bondStrength(int bond) const { return bondStrength_[bond]; }

    /// Whether any bond can break by its traction (`fracture = "bond"`).
    bool bondsBreak() const;
    /// Whether any cell can leave its neighbours (`fracture = "cell"`).
    bool cellsBreak() const;
    bool breakable() const { return bondsBreak() || cellsBreak(); }

    State initialState() const;

  private:
    void layOutCells();
    void layOutNodes();
    void makeBonds();
    void makeEvents();
    void makeObjects();
    void findOverlaps();
    void findUnequalCells();
    int lawFor(int material, const Vec3& cellSize);

    WorldDescription description_;
    std::vector<Body> bodies_;
    std::vector<ElementLaw> laws_;
    std::vector<Event> events_;
    std::vector<Object> objects_;
    std::vector<Throw> throws_;
    std::vector<Parting> partings_;
    std::vector<int> cellBody_;
    std::vector<std::int16_t> cellLaw_;
    std::vector<double> nodeMass_;
    std::vector<std::uint8_t> anchored_;
    std::vector<float> bondStrength_;
    int presentCells_ = 0;
    bool unequalCells_ = false;
    int bondCount_ = 0;
};

}  // namespace sunder
