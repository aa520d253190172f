#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/material.hpp"
#include "core/object.hpp"
#include "core/types.hpp"

namespace sunder::core {

/// Sides of a body, seen from +z: left/right are −x/+x, bottom/top −y/+y, back/front −z/+z of its
/// own axes, so they turn with it.
enum class Side : std::uint8_t { Left, Right, Bottom, Top, Back, Front };

// What a world is to be, by whoever describes it: a scene file or code. Ranges stand in
// core/rules.hpp; World refuses what core/check.hpp does. Names are for messages and files: one
// line of up to 64 bytes of UTF-8, nobody else's of the same kind; or empty.

/// Replaces the material of a box of cells, or removes them.
struct RegionDescription {
    IVec3 from{0, 0, 0};  ///< first cell, from 0
    IVec3 to{0, 0, 0};    ///< last cell, inclusive, not before the first and in the body
    int material = -1;    ///< index into WorldDescription::materials, or −1: no cells here
};

/// A block of cells on one lattice, which is turned about its position. What belongs to the body is
/// told in its own axes and turns with it: size, cells, sides, regions, grain, bricks and
/// strengths.
struct BodyDescription {
    std::string name;
    Vec3 size{1, 1, 1};      ///< m, each 0.001 to 1000
    IVec3 cells{1, 1, 1};    ///< cells along x, y, z, each from 1; kMaxCells in all bodies
    Vec3 position{0, 0, 0};  ///< m, centre of the bottom face, each −1e4 to 1e4
    /// From the body's own axes to the world's, of length 1: the axes themselves by default.
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
    int material = 0;                        ///< index into WorldDescription::materials
    std::vector<Side> anchors;               ///< sides that do not move, each once
    std::vector<RegionDescription> regions;  ///< later ones override earlier ones; up to 256
    bool mayOverlap = false;                 ///< when the world begins (core/overlap.hpp)
    /// Whether it is there when the world begins. False: laid out and checked as the others are,
    /// but not there until Solver::setPresent() puts it there.
    bool present = true;
    std::string where;  ///< for error messages, for example "wood.toml:31: body 1: position"
};

/// Something that pushes a patch of a body for a while: all nodes whose rest position lies within
/// `radius` of `point` get the same acceleration. Or what a ball holds of all bodies (kEveryBody)
/// and of objects, wherever they are by then: a blast.
struct EventDescription {
    enum class Kind {
        Impulse,   ///< vector is the whole momentum given to the patch, N·s
        Force,     ///< vector is the whole force on the patch, N
        Velocity,  ///< vector is the change of velocity of the patch were it free, m/s
    };
    double time = 0;         ///< s, 0 to 1e5
    double duration = 5e-3;  ///< s, > 0 to 1e5; an impulse is spread evenly over it: less dust
    Kind kind = Kind::Impulse;
    int body = 0;  ///< index into WorldDescription::bodies, or kEveryBody
    /// m, relative to the body's position and along its own axes, so that the same place of a wall
    /// is pushed however the wall is turned; of every body: in the world; each −1e4 to 1e4.
    Vec3 point{0, 0, 0};
    double radius = 0.1;   ///< m, > 0 to 1e4; of one body: a free node of it must lie inside
    Vec3 vector{0, 0, 0};  ///< N·s, N or m/s, along the world's axes, each −1e12 to 1e12
    /// Only of every body, whose kind must be Velocity: m/s, −1e12 to 1e12, added to `vector` in
    /// the direction away from `point`; and whether all of it lessens towards the rim, by
    /// 1 − d²/radius² at distance d.
    double outward = 0;
    bool falloff = false;
    std::string where;  ///< for error messages, for example "wood.toml:31: event 1"
};

/// Four walls, upright without end, that nothing passes (core/room.hpp). The floor is the ground's.
struct RoomDescription {
    /// m, −1e4 to 1e4, where the walls stand: low, high.
    std::array<double, 2> x{-4, 4}, z{-3, 3};
    double friction = 0.6;          ///< Coulomb coefficient, 1, 0 to 10
    std::optional<double> ceiling;  ///< m, its height, > 0 to 1e4
};

/// Everything about a world, not yet laid out as cells and nodes. At least one material and one
/// body; at most 1e4 bodies, 250 objects, 1e4 events and as many throws.
struct WorldDescription {
    std::vector<Material> materials;
    std::vector<BodyDescription> bodies;
    std::vector<EventDescription> events;
    std::vector<ObjectDescription> objects;  ///< need contact
    std::vector<ThrowDescription> throws;
    Vec3 gravity{0, -9.81, 0};    ///< m/s², each −1000 to 1000
    bool ground = true;           ///< a floor at y = 0
    double groundFriction = 0.6;  ///< Coulomb coefficient, 1, 0 to 10
    std::optional<RoomDescription> room;
    bool contact = false;  ///< whether cells push each other (core/contact.hpp)
    /// m/s, 0.2 to 100 (slower is rest): what overlaps, and did not come to by a hit, parts no
    /// faster (core/overlap.hpp).
    double partingSpeed = 1;
    double step = 1.0 / 3000;  ///< s, one substep, 1e-6 to 0.1
    /// Substeps from one fracture update to the next, 1 to 100; 0: World::fractureInterval() finds
    /// how many.
    int fractureInterval = 0;
    std::uint64_t seed = 1;  ///< of the strength map
};

}  // namespace sunder::core
