#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/material.hpp"
#include "core/object.hpp"
#include "core/types.hpp"

namespace sunder::core {

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

/// Something that pushes a patch of a body for a while: all nodes whose rest position lies within
/// `radius` of `point` get the same acceleration. Or what a ball holds of all bodies (kEveryBody),
/// wherever they are by then: a blast.
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
    int body = 0;         ///< index into WorldDescription::bodies, or kEveryBody
    Vec3 point{0, 0, 0};  ///< m, relative to the body's position; of every body: in the world
    double radius = 0.1;  ///< m
    Vec3 vector{0, 0, 0};
    /// Only of every body, whose kind must be Velocity: m/s, added to `vector` in the direction
    /// away from `point`; and whether all of it lessens towards the rim, by 1 − d²/radius² at
    /// distance d.
    double outward = 0;
    bool falloff = false;
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

}  // namespace sunder::core
