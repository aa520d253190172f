#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/world.hpp"

namespace sunder::cpu {

/// Vectors are at most this many floats long; every array is padded to whole ones.
inline constexpr int kLanes = 16;
/// Stands for "never": no stress reaches it, and its square is still finite.
inline constexpr float kUnbreakable = 1e18f;

/// m/s. A blow of v strains a body by about v over its wave speed. Where the least wave speed of
/// its materials is larger than this, rotations are found the cheap way for tiny strains wherever
/// it will do; in softer bodies it would do so seldom that to try costs more than it saves.
inline constexpr double kStiffWaveSpeed = 500;

/// Material constants as the kernels want them.
struct Law {
    float lambda, twoMu;  ///< Pa
    float corotated;      ///< 1, or 0: Green's strain
    float stressScale;    ///< S = √(E/E_eff)
    float damageRate;     ///< 1/τ, 1/s
    float shearWeight, friction;
    float maxStress;       ///< Pa; kUnbreakable unless fracture = cell
    float suddenTraction;  ///< Pa; kUnbreakable unless E is limited
    float hotStress;       ///< what strongly deformed elements scale their stress with
    float hotDeterminant;  ///< det F below which they are that
    float hotRate;         ///< Pa, their viscosity over b·h
    float nodeMass;        ///< kg, of one corner of a cell
    float largestStress;   ///< Pa, |P| by Green's law
};

/// Which constants a body's cells need: all the same law, or one law per cell.
enum class LawKind { Green, Corotated, Mixed };

/// One body's cells as arrays of components. x runs fastest and the longer of y and z slowest, so
/// that all neighbours of a stretch of cells lie within one slice on either side. What only the
/// cell itself reads comes in tiles, all components of kLanes cells together, which memory delivers
/// in one stream; what neighbours read, too, in one array per component, `stride` apart.
struct BodyArrays {
    // --- layout ---
    int index = 0;       ///< in World::bodies()
    int cells = 0;       ///< of the body, absent ones included
    int vectors = 0;     ///< cells rounded up to whole kLanes, over kLanes
    int extent[3] = {};  ///< cells along x, y, z
    int steps[3] = {};   ///< from a cell to its +x, +y, +z neighbour
    int reach = 0;       ///< farthest step to a cell around the same lattice point
    std::ptrdiff_t stride = 0;

    // --- state ---
    float* displacement = nullptr;  ///< m from rest, tiles of corner·3 + axis
    float* velocity = nullptr;      ///< m/s, likewise
    float* damage = nullptr;        ///< [axis][cell], bonds
    float* slow = nullptr;          ///< Pa, [axis][cell]
    float* slowStress = nullptr;  ///< Pa, [cell]; only with cells that break and whose stiffness is
                                  ///< limited

    // --- worked out in every step ---
    float* force = nullptr;   ///< N, [corner·3 + axis][cell], of this copy alone
    float* stress = nullptr;  ///< Pa, [6·t + component][cell]: T of corner tetrahedron t; xx yy zz
                              ///< xy yz zx; only with bonds that can break
    float* over = nullptr;    ///< [cell] 1 where the cell's stress exceeds maxStress; else 0

    // --- constant, or constant until a bond breaks or its anchors let go ---
    bool released = false;         ///< they have
    float* strength = nullptr;     ///< Pa, [axis][cell]
    float* side = nullptr;         ///< [cell] +1 or −1 by parity: which way the cell is mirrored
    float* inverseMass = nullptr;  ///< 1/kg, of joined groups, tiles of corners; 0: held
    float* rest[3] = {};           ///< m, per axis, [0 lower, 1 upper corners][cell]; y only with a
                                   ///< ground or room, x and z only with a room
    std::uint8_t* links = nullptr;     ///< tiles of corners, core/links.hpp
    std::uint8_t* broke = nullptr;     ///< [cell] bits 0–2: bonds broken and not yet in `links`
    std::int32_t* lawIndex = nullptr;  ///< [cell], only of LawKind::Mixed

    /// The nodes around a lattice point, for the copy at each corner: bit in the link mask, and
    /// where that node's force lies, from this cell's place in `force`. Octants that the body's
    /// shape rules out are left away.
    struct Member {
        std::uint32_t bit;
        std::ptrdiff_t offset;
    };
    std::array<std::array<Member, 8>, 8> members{};
    int memberCount = 8;

    LawKind kind = LawKind::Corotated;
    bool stiff = true;  ///< whether its strains are likely to be tiny: see kStiffWaveSpeed
    bool bondsBreak = false, cellsBreak = false;  ///< whether any cell has that fracture mode
    bool stressLost = false;                      ///< whether cellsBreak goes with S > 1
    const Law* laws = nullptr;                    ///< table of all laws
    Law law{};                                    ///< unless Mixed
    bool turned = false;                          ///< whether its axes are not the world's
    float axes[3][3] = {};                        ///< its own in the world, one after the other
    float inverseCell[3] = {};                    ///< 1/m
    float forceWeight[3] = {};                    ///< m², volume/(6·edge)
    float dampingTime = 0;                        ///< b·h, s
    float step = 0, drag = 0;                     ///< s, exp(−d·h)
    float slowShare = 0;                          ///< core/traction.hpp
    float gravity[3] = {};                        ///< m/s²
    bool ground = false, room = false;
    float groundFriction = 0, roomFriction = 0;
    float roomLow[3] = {}, roomHigh[3] = {};  ///< m; infinite where there is no barrier
    float returnShare = 0, returnWay = 0;     ///< what lies beyond one comes back by in a step: of
                                              ///< its depth; at most, m

    int place(int x, int y, int z) const { return x * steps[0] + y * steps[1] + z * steps[2]; }
    /// Lattice coordinates of the cell at a place.
    core::IVec3 coordinates(int place) const {
        const int slowest = steps[2] > steps[1] ? 2 : 1, middle = 3 - slowest;
        core::IVec3 c;
        c[slowest] = place / steps[slowest];
        c[middle] = place % steps[slowest] / steps[middle];
        c[0] = place % steps[slowest] % steps[middle];
        return c;
    }
};

inline constexpr int kNodeComponents = 3 * core::kCorners;

/// Where component number `component` of `count` stands for a cell in an array of tiles.
constexpr std::ptrdiff_t tiled(int count, int component, int cell) {
    return (static_cast<std::ptrdiff_t>(cell / kLanes) * count + component) * kLanes +
           cell % kLanes;
}

/// A push that acts in the step in progress.
struct Push {
    const std::uint8_t* patch;  ///< [cell] bit per corner: in the patch
    float acceleration[3];      ///< m/s², weighted with the share of the step
};

/// Memory for the arrays of one body, aligned and padded. Moves, does not copy.
class BodyStorage {
  public:
    BodyStorage(const core::World& world, int body, const std::vector<Law>& laws);
    BodyArrays& arrays() { return arrays_; }
    const BodyArrays& arrays() const { return arrays_; }
    std::size_t bytes() const { return bytes_; }

  private:
    struct Free {
        void operator()(std::byte* memory) const;
    };
    void choose(const core::World& world);
    void allocate();
    void fill(const core::World& world);

    BodyArrays arrays_;
    std::unique_ptr<std::byte[], Free> memory_;
    std::size_t bytes_ = 0;
};

std::vector<Law> makeLaws(const core::World& world);

/// Works out link masks and masses of joined groups: everywhere, or around the bonds in `broke`,
/// which it clears. `nodeMass` is taken from the world.
void relinkAll(const core::World& world, BodyArrays& body);
void relinkBroken(const core::World& world, BodyArrays& body);

}  // namespace sunder::cpu
