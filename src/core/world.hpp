#pragma once
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/cell.hpp"
#include "core/constants.hpp"
#include "core/description.hpp"
#include "core/element_law.hpp"
#include "core/event.hpp"
#include "core/overlap.hpp"
#include "core/state.hpp"

namespace sunder::core {

struct Body {
    std::string name;
    IVec3 cells;
    Vec3 cellSize;  ///< m, along its own axes
    Vec3 origin;    ///< m, in the world: the corner that lies lowest along its own axes
    Mat3 axes = Mat3::Identity();  ///< its own, in the world, as columns
    bool turned = false;           ///< whether they are others than the world's
    int firstCell = 0;
    double drag = 0;  ///< 1/s, mass-weighted mean of its cells' `damping`
    Vec3 gravity{0, 0,
                 0};  ///< m/s², the scene's times the mass-weighted mean of its cells' `gravity`
    double calmest = std::numeric_limits<double>::infinity();  ///< m/s: see core/sleep.hpp

    int cellCount() const { return cells.prod(); }
    Vec3 size() const { return cellSize.cwiseProduct(cells.cast<double>()); }  ///< m
    /// m, in the world, of a place at rest that lies `own` from the origin along the body's axes.
    Vec3 inWorld(const Vec3& own) const { return origin + (turned ? Vec3(axes * own) : own); }
    /// Of its cells at rest, along the world's axes.
    Box bounds() const;
    /// World-wide index of the cell at lattice coordinates c (must lie inside).
    int cellAt(const IVec3& c) const {
        return firstCell + c[0] + cells[0] * (c[1] + cells[1] * c[2]);
    }
    IVec3 coordinates(int cell) const;
    bool contains(const IVec3& c) const;
};

/// Steps from one fracture update to the next where a material's E is all that the step carries: a
/// wave crosses some three cells in them.
inline constexpr int kLookSteps = 4;

/// Up to here a spring of the lighter cell's mass carries a few layers of the heavier ones.
inline constexpr double kUnequal = 8;

/// Bodies laid out as cells, nodes and bonds: everything that does not change while time runs.
/// Cells of all bodies share one numbering, dense within a body (x fastest), so neighbours follow
/// from the lattice.
class World {
  public:
    /// Throws InputError for whatever check() refuses (core/check.hpp), more cells than memory,
    /// bodies without cells, events beside their bodies, and things in one another
    /// (core/overlap.hpp).
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
    /// Steps from one fracture update to the next: by the description, or as long as a wave takes
    /// to cross a few cells of the stiffest material that breaks. So it is the same time however
    /// many steps there are: kLookSteps times the longest step that would carry that material. But
    /// no longer than contactTime(): what hits soft things may be faster than their waves.
    int fractureInterval() const { return fractureInterval_; }
    /// Steps from one search for contacts to the next, a multiple of kContactSteps: kContactTime,
    /// or where steps are long kContactSteps of them.
    int contactInterval() const { return contactInterval_; }
    double contactTime() const { return contactInterval_ * step(); }             ///< s, that is
    double pushSpeed() const { return kPushShare * description_.partingSpeed; }  ///< U, m/s

    int cellCount() const { return static_cast<int>(cellBody_.size()); }
    int nodeCount() const { return kCorners * cellCount(); }
    int bondSlots() const { return kBondsPerCell * cellCount(); }
    int presentCells() const { return presentCells_; }
    /// Whether cells that may touch are so unequal that contact has to take in what the lighter
    /// ones bear (core/contact.hpp): some have more than kUnequal times the mass of others.
    bool unequalCells() const { return unequalCells_; }
    int bondCount() const { return bondCount_; }
    /// Whether any body's own axes are not the world's.
    bool anyTurned() const;

    /// False for cells a region removed.
    bool present(int cell) const { return cellLaw_[cell] >= 0; }
    /// False for the cells of bodies that are not there, too.
    bool present(int cell, const State& state) const {
        return present(cell) && state.has(bodyOf(cell));
    }
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
    /// m, from the cell's corner 0 at rest, along the body's own axes; not rounded, so the shape of
    /// a cell does not depend on where it stands.
    Vec3 cornerOffset(int cell, int corner) const;
    double nodeMass(int node) const {
        return nodeMass_[node];
    }  ///< kg, of this copy alone; 0 where the cell is absent
    /// kg, of a present cell.
    double cellMass(int cell) const { return kCorners * nodeMass_[kCorners * cell]; }
    /// As described.
    bool anchored(int node) const { return anchored_[node] != 0; }
    /// False where the body's anchors have let go.
    bool anchored(int node, const State& state) const {
        return anchored(node) && !state.hasReleased(bodyOf(node / kCorners));
    }
    /// Pa; infinite where nothing but whole-cell fracture can break the bond.
    float bondStrength(int bond) const { return bondStrength_[bond]; }

    /// Whether any bond can break by its traction (`fracture = "bond"`).
    bool bondsBreak() const;
    /// Whether any cell can leave its neighbours (`fracture = "cell"`).
    bool cellsBreak() const;
    bool breakable() const { return bondsBreak() || cellsBreak(); }

    State initialState() const;
    /// A body that is to be in `state` or not, whole and at rest as initialState() has it.
    void setPresent(State& state, int body, bool present) const;
    /// Copies what states say of a body's cells.
    void copyBody(const State& from, int body, State& to) const;
    /// A body whose anchors are to let go, if it is there and has any.
    void releaseAnchors(State& state, int body) const;

    /// 64-bit FNV-1a of all that states and their future depend on: worlds of the same description
    /// have the same one on every machine.
    std::uint64_t fingerprint() const { return fingerprint_; }

    /// What an event means in this world whose `time` counts from `now`, s. Throws InputError for
    /// what checkEvent() refuses (core/check.hpp), and where it could push nothing. released:
    /// whether the body's anchors have let go, so that nodes there are pushed, too.
    Event makeEvent(EventDescription, double now = 0, bool released = false) const;
    /// How an object leaves a throw. Throws InputError for what checkThrow() refuses.
    ObjectState makeThrow(const ThrowDescription&) const;

  private:
    void layOutCells();
    void findIntervals();
    void layOutNodes();
    void makeBonds();
    void makeEvents();
    /// `name`: of the event, in messages.
    Event layOutEvent(const EventDescription&, const std::string& name,
                      bool released = false) const;
    void makeObjects();
    void findOverlaps();
    void findUnequalCells();
    int lawFor(int material, const Vec3& cellSize);
    std::uint64_t findFingerprint() const;

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
    int fractureInterval_ = 0, contactInterval_ = 0;
    int presentCells_ = 0;
    bool unequalCells_ = false;
    int bondCount_ = 0;
    std::uint64_t fingerprint_ = 0;
};

}  // namespace sunder::core
