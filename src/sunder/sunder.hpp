/// Sunder: walls that bend, crack and splinter in real time, in your own program.
///
/// Describe a world (WorldDesc), make it (World::create()), hit it (World::push()), let time pass
/// (World::step()), and draw it: on a GPU with gl::Surface (sunder/gl.hpp). docs/embedding.md leads
/// through it, examples/ has programs to start from.
///
/// Units are metres, seconds, kilograms, newtons, radians; y is up. Text is UTF-8. Nothing throws:
/// what can fail returns a Result. Numbers are checked; what makes no sense is refused with a
/// sentence and changes nothing.
///
/// Threads: one world is used by one thread at a time; different worlds may be used by different
/// threads at once. A world on a GPU belongs to the thread on which its context is current.
#pragma once
#include <sunder/export.h>
#include <sunder/material.hpp>
#include <sunder/tasks.hpp>
#include <sunder/types.hpp>
#include <sunder/version.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder {

namespace sim {
class Backend;
}

/// Sides of a body in its own axes, one or several: `Side::Left | Side::Right`.
enum class Side : unsigned {
    None = 0,    ///< No side.
    Left = 1,    ///< −x.
    Right = 2,   ///< +x.
    Bottom = 4,  ///< −y.
    Top = 8,     ///< +y.
    Back = 16,   ///< −z.
    Front = 32,  ///< +z.
};
/// All sides of both.
constexpr Side operator|(Side a, Side b) {
    return static_cast<Side>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
/// The sides that both have.
constexpr Side operator&(Side a, Side b) {
    return static_cast<Side>(static_cast<unsigned>(a) & static_cast<unsigned>(b));
}

/// Gives a box of a body's cells another material, or takes them away.
struct RegionDesc {
    IVec3 from{};       ///< First cell, counted from 0.
    IVec3 to{};         ///< Last cell, included; not before the first, and in the body.
    int material = -1;  ///< What WorldDesc::addMaterial() returned, or −1: no cells here.
};

/// A body: a block of cells that bends and breaks.
struct BodyDesc {
    /// For messages: one line of up to 64 bytes, or empty; no other body has it.
    std::string name{};
    int material = 0;      ///< What WorldDesc::addMaterial() returned.
    Vec3 size{1, 1, 1};    ///< m, each 0.001 to 1000.
    IVec3 cells{1, 1, 1};  ///< Cells along x, y, z, each from 1. All bodies: up to 4,000,000.
    Vec3 position{};       ///< m, world, each −1e4 to 1e4: centre of the bottom face.
    Quat orientation{};  ///< How it is turned about its position: sides, cells, grain turn with it.
    Side anchors = Side::None;          ///< Sides that never move.
    std::vector<RegionDesc> regions{};  ///< Up to 256; later ones override earlier ones.
    /// Whether it may lie within others as the world begins.
    bool mayOverlap = false;
    /// Whether it is there when the world begins. False: room is kept for it until
    /// World::addBody(). It is checked as the others are.
    bool present = true;
};

/// A rigid object: something thrown, something hanging, an obstacle, a door, a player. Made by
/// sphere(), box() or capsule(); what else it is, its fields say.
struct SUNDER_API Object {
    /// What it looks like to a collision.
    enum class Shape {
        Sphere,   ///< A ball.
        Box,      ///< A block.
        Capsule,  ///< A cylinder along its own y axis with round ends.
    };

    /// A ball. m, 0.001 to 1000.
    static Object sphere(double radius);
    /// A block. m, its edges, each 0.001 to 1000.
    static Object box(Vec3 size);
    /// A capsule along y. m: radius 0.001 to 1000; whole length from twice the radius to 2000.
    static Object capsule(double radius, double length);

    /// The same, moved by nothing but World::setKinematic(): a door, a player, a vehicle. It pushes
    /// what is in its way as if it weighed without end.
    Object kinematic() const;
    /// The same, never moved: an obstacle.
    Object fixed() const;
    /// The same, with its centre there as the world begins. m, each −1e4 to 1e4.
    Object at(Vec3 position) const;

    std::string name{};           ///< For messages: one line of up to 64 bytes, or empty.
    Shape shape = Shape::Sphere;  ///< Its shape.
    Vec3 size{0.2, 0.2, 0.2};  ///< m: a box's edges; of a sphere x is its diameter; of a capsule x
                               ///< is its diameter, y its whole length.
    double mass = 1;           ///< kg, 1e-6 to 1e9; of no account where it is fixed or kinematic.
    /// m, world: its centre, each −1e4 to 1e4. None: it is not there until it is thrown or put
    /// somewhere (World::throwObject(), World::setKinematic()).
    std::optional<Vec3> position{};
    Quat orientation{};              ///< How it is turned.
    Vec3 velocity{};                 ///< m/s, each −1e4 to 1e4.
    Vec3 spin{};                     ///< rad/s, about the world's axes, each −1e4 to 1e4.
    double friction = 0.5;           ///< Coulomb's, 0 to 10; with what it touches: the mean.
    double restitution = 0.3;        ///< 0 to 1; likewise.
    double drag = 0.05;              ///< 1/s, 0 to 1000, of motion and spin.
    bool isFixed = false;            ///< Never moves.
    bool isKinematic = false;        ///< Moved by nothing but World::setKinematic().
    std::optional<Vec3> hungFrom{};  ///< m, world: it hangs from here on a chain that is straight.
    Vec3 colour{0.25, 0.25, 0.28};   ///< Linear RGB, each 0 to 1; in Sunder's own pictures.
    bool mayOverlap = false;         ///< Whether it may lie within others as the world begins.
};

/// All bodies and objects, of Push::body.
inline constexpr int kEveryBody = -1;

/// A push: a hit, a shove, an explosion. Exactly one of `velocity`, `impulse` and `force` or, of
/// every body, `outward` has to be other than zero; `outward` may go with `velocity`.
struct Push {
    /// What is pushed: kEveryBody, all that a ball around `at` holds while the push acts, wherever
    /// it has moved to, objects among it, unless they are fixed or kinematic; or one body (what
    /// WorldDesc::addBody() returned), of which the patch around `at` is pushed to the end,
    /// wherever it moves.
    int body = kEveryBody;
    /// m, world, each −1e4 to 1e4. Of one body: at rest, where it was when the world began
    /// (RayHit::restPlace).
    Vec3 at{};
    double radius = 0.1;  ///< m, above 0 to 1e4.
    Vec3 velocity{};  ///< m/s, each −1e12 to 1e12: how much faster it would be if it were free.
    Vec3 impulse{};   ///< N·s, likewise: all of it together. Only of one body.
    Vec3 force{};     ///< N, likewise: all of it together. Only of one body.
    /// m/s, −1e12 to 1e12: the same as `velocity`, away from `at`. Only of every body.
    double outward = 0;
    /// Whether it lessens towards the rim, by 1 − d²/radius² at distance d. Only of every body.
    bool falloff = false;
    double duration = 5e-3;  ///< s, above 0 to 1e5: for how long it acts.
    double delay = 0;        ///< s, 0 to 1e5, from now: when it begins.
};

/// Puts an object somewhere and lets it go.
struct Throw {
    double time = 0;  ///< s, 0 to 1e5, since the world began.
    int object = 0;   ///< What WorldDesc::addObject() returned: neither fixed, kinematic nor hung.
    Vec3 from{};      ///< m, world, each −1e4 to 1e4: its centre.
    Vec3 velocity{};  ///< m/s, each −1e4 to 1e4.
    Vec3 spin{};      ///< rad/s, about the world's axes, each −1e4 to 1e4.
};

/// Walls of a room, upright and without end, that nothing passes.
struct RoomDesc {
    double minX = -4;                 ///< m, −1e4 to 1e4, less than maxX.
    double maxX = 4;                  ///< m, −1e4 to 1e4.
    double minZ = -3;                 ///< m, −1e4 to 1e4, less than maxZ.
    double maxZ = 3;                  ///< m, −1e4 to 1e4.
    double friction = 0.6;            ///< Coulomb's, 0 to 10.
    std::optional<double> ceiling{};  ///< m, its height, above 0 to 1e4.
};

/// Everything about a world before it is made. Copied by World::create().
struct SUNDER_API WorldDesc {
    /// A scene that comes with Sunder, such as "wood" or "brick", with what hits it. Fails with the
    /// list of them where there is none of this name.
    static Result<WorldDesc> preset(std::string_view name);
    /// What a scene file says (docs/scenes.md), with its pushes and throws. `path`: with a '/' or
    /// ending in ".toml". Fails with the line of the first thing that is wrong.
    static Result<WorldDesc> load(std::string_view path);

    /// Returns its index, for BodyDesc::material.
    int addMaterial(Material material);
    /// The same; World::create() fails with the error where there is no material.
    int addMaterial(Result<Material> material);
    /// Returns its index, for Push::body and what the world reports.
    int addBody(BodyDesc body);
    /// Returns its index, for World::throwObject() and its like. Makes `contact` true: objects need
    /// it.
    int addObject(Object object);

    std::vector<Material> materials{};  ///< At least one, up to 1000.
    std::vector<BodyDesc> bodies{};     ///< At least one, up to 10,000.
    std::vector<Object> objects{};      ///< Up to 250.
    std::vector<Push> pushes{};         ///< Known beforehand: `delay` counts from the beginning.
    std::vector<Throw> throws{};        ///< Known beforehand.
    Vec3 gravity{0, -9.81, 0};          ///< m/s², each −1000 to 1000.
    bool ground = true;                 ///< Whether there is a floor at y = 0.
    double groundFriction = 0.6;        ///< Coulomb's, 0 to 10.
    std::optional<RoomDesc> room{};     ///< Walls around everything.
    /// Whether pieces push each other. Off: they pass through each other, at half the cost.
    bool contact = true;
    /// m/s, 0.2 to 100: what overlaps as the world begins parts no faster.
    double partingSpeed = 1;
    /// s, 1e-6 to 0.1: one substep. Shorter: stiffer materials, more work a second.
    double substep = 1.0 / 3000;
    /// Substeps from one look for fracture to the next, 1 to 100; 0: as many as a wave takes to
    /// cross a few cells of the stiffest material.
    int fractureInterval = 0;
    std::uint64_t seed = 1;  ///< Of the scatter of strengths: another one breaks another way.

    /// Why a material that was to be added is none; World::create() fails with it.
    std::optional<Error> missing{};
};

/// Where a world can be simulated other than on the CPU: a gl::Device (sunder/gl.hpp).
class SUNDER_API Device {
  public:
    virtual ~Device();  ///< After its worlds.

  protected:
    /// For gl::Device.
    Device() = default;

  private:
    friend class World;
    virtual Result<sim::Backend*> backend() = 0;
};

/// How a world is simulated.
struct WorldOptions {
    /// Where: null: on the CPU. It must outlive the world.
    Device* device = nullptr;
    /// The host's threads; null: oneTBB's, of an arena of its own. It must outlive the world.
    const TaskSystem* tasks = nullptr;
    /// By which solver: "cpu" or "reference"; with a device "gather", "compute", "scatter" or
    /// "auto", too (docs/solvers.md). Empty: "gather" with a device, else "cpu".
    std::string_view solver{};
    int threads = 0;       ///< Of a solver with threads, 1 to 1024; 0: as many as there are cores.
    int incidents = 4096;  ///< How many are kept until they are taken, 0 (none) to 1e6.
    /// Whether what stands begins at rest under its own weight, which may take seconds to find;
    /// else weight acts as a blow in the first moment.
    bool settle = true;
    /// Told how much of that is done, 0 to 1.
    std::function<void(double)> progress{};
};

/// Something that happened: for sounds, particles, rules of a game.
struct Incident {
    /// What happened.
    enum class Kind {
        Contact,  ///< A piece or an object hit a cell.
        Break,    ///< A bond between two cells gave way.
    };
    Kind kind = Kind::Contact;  ///< What happened.
    double time = 0;            ///< s, World::time() of the look that found it, up to 1/60 s later.
    Vec3 place{};               ///< m, world.
    double impulse = 0;      ///< N·s: of a contact what was given, of a break what the bond bore.
    int body = -1;           ///< Whose cell it is.
    int material = -1;       ///< Of that cell.
    int otherBody = -1;      ///< What hit it, or had the bond's other cell; −1: an object did.
    int otherMaterial = -1;  ///< Of the other cell; −1: an object hit it.
    int object = -1;         ///< The object that hit it; −1: a cell did.
};

/// What hangs together: cells that a chain of unbroken bonds joins.
struct Piece {
    int body = -1;          ///< Whose cells they are.
    int cells = 0;          ///< How many.
    double mass = 0;        ///< kg.
    Vec3 centre{};          ///< m, world: of its mass.
    Vec3 velocity{};        ///< m/s, of its centre of mass.
    Vec3 min{};             ///< m, world: its bounds.
    Vec3 max{};             ///< m, world: its bounds.
    bool anchored = false;  ///< Whether something of it never moves.
};

/// What a ray meets first.
struct RayHit {
    double distance = 0;  ///< m, from the ray's origin.
    Vec3 place{};         ///< m, world.
    Vec3 normal{};        ///< Of length 1, out of what was hit.
    int body = -1;        ///< Whose cell it is; −1: an object was hit.
    int material = -1;    ///< Of that cell; −1: an object was hit.
    int object = -1;      ///< The object; −1: a cell was hit.
    Vec3 restPlace{};     ///< m, world: where that was as the world began, for Push::at.
};

/// Where an object is and how it moves.
struct ObjectState {
    bool present = false;   ///< Whether it is there at all.
    Transform transform{};  ///< Where it is.
    Vec3 velocity{};        ///< m/s.
    Vec3 spin{};            ///< rad/s, about the world's axes.
};

/// How much of everything a world has.
struct WorldSize {
    int cells = 0;  ///< Cells that are there, of all bodies.
    int nodes = 0;  ///< Nodes, eight a cell.
    int bonds = 0;  ///< Faces between two cells of a body.
};

/// Bodies and objects on their way through time.
class SUNDER_API World {
  public:
    /// Makes a world. Fails, and nothing is made, where the description makes no sense, the memory
    /// is too small or the device cannot do it.
    static Result<World> create(const WorldDesc& description, const WorldOptions& options = {});

    World(World&& other) noexcept;  ///< What is moved from can only be destroyed or assigned.
    World& operator=(World&& other) noexcept;  ///< Likewise. Destroys what it was.
    /// Of a world on a GPU: on the thread on which its context is current.
    ~World();

    // --- Time ---

    /// Lets time pass: whole substeps, as many as fit; the rest is kept for the next call. The same
    /// calls give the same bits, with one solver on one driver; with "cpu" on every machine. On a
    /// GPU it returns before the work is done, reads nothing back and waits for nothing. s, 0 to
    /// 100. Who calls it with the length of a frame had better bound that, lest one slow frame make
    /// the next one slow as well.
    Result<void> step(double seconds);
    /// s, since the world began: of the last substep.
    double time() const;
    /// Substeps since the world began.
    std::int64_t substeps() const;
    /// Waits until all of it is done, on a GPU as well.
    Result<void> finish();

    // --- Input: acts from the next substep on ---

    /// Pushes. Nothing is read back, and nothing waits. The same bits follow as from the same event
    /// in a scene file. Fails where it makes no sense, or where there is nothing of that body.
    Result<void> push(const Push& push);
    /// Throws an object at once; `time` is of no account.
    Result<void> throwObject(const Throw& thrown);
    /// Puts a kinematic object there, from where it goes on with this velocity until it is set
    /// again. m, each −1e4 to 1e4; m/s and rad/s, each −1e4
    /// to 1e4.
    Result<void> setKinematic(int object, const Transform& transform, Vec3 velocity,
                              Vec3 spin = {});
    /// Takes an object away, until it is thrown or set again.
    Result<void> removeObject(int object);
    /// Puts a body there that is not: whole, and at rest where its description has it, though not
    /// under its own weight yet. What sleeps around it wakes; what lies in its way is pushed out,
    /// hard: leave it room. At once at a substep where contacts are searched for (every 1/750 s,
    /// but no more often than every fourth), else within the next step() at the next such one; a
    /// push of it that is given meanwhile begins then, too. So what touches nothing of it keeps its
    /// bits. With the solver `scatter` it waits for the GPU. Refused: no such body, or it is there
    /// already.
    Result<void> addBody(int body);
    /// Takes a body away, and all its pieces, until addBody(), at the same substeps: no ray, push
    /// or object meets it, nothing draws it, and what lay on it falls. With the solver `scatter` it
    /// waits for the GPU. Refused: no such body, or it is not there.
    Result<void> removeBody(int body);
    /// Lets go of a body's anchors (BodyDesc::anchors): from now on nothing holds it but what it
    /// rests on. Nothing is read back, and nothing waits. They hold anew where it is taken away and
    /// added again. Refused: no such body, it is not there, or it has no anchors.
    Result<void> releaseAnchors(int body);
    /// Makes the world larger, where no room was kept (BodyDesc::present): it gets what
    /// `description` has beyond it, the materials, bodies and objects at the ends of its lists; at
    /// nothing else of it is looked. Indices stay what they are. New bodies begin as with
    /// addBody(), those that are not `present` later. It takes as long as create() without
    /// `settle` (notes() tell), waits for a GPU, and needs room for both worlds meanwhile.
    /// Everything wakes, so bits differ from those of a world that had the room from the start, and
    /// states that were saved before fit no longer. A Surface follows with its next update(): its
    /// names, ranges and numbers are others then. Fails, and nothing has changed, as create() does,
    /// or where the description has less than the world.
    Result<void> extend(const WorldDesc& description);

    // --- Going back ---

    /// All of it as bytes, from which restoreState() goes on to the bit, in this world or in
    /// another of the same description and solver, with this version of Sunder ("auto" restores
    /// places and speeds, and wakes what sleeps). Changes nothing. On a GPU it waits and reads the
    /// state.
    Result<std::vector<std::byte>> saveState() const;
    /// Goes on from there. Incidents that were found before stay with who has them. Fails, and
    /// changes nothing, for bytes that were cut or changed, or are of another version, world or
    /// solver.
    Result<void> restoreState(std::span<const std::byte> bytes);

    // --- Output ---

    /// What has happened since the last call, oldest first; valid until the next. On a GPU things
    /// are found a thirtieth of a second late.
    std::span<const Incident> incidents();
    /// How many were lost because nobody took them in time, or a GPU had no room for them.
    std::int64_t droppedIncidents() const;
    /// s: of the state that castRay(), pieces(), object() and brokenBonds() tell of. On the CPU,
    /// and after finish(), that is time(). On a GPU they look at the state of two calls of step()
    /// ago, which is copied as they go, so that nothing waits; which one it is depends on the calls
    /// alone. They do wait where none of them was called for 60 steps, or where a body came or
    /// went, or a state was restored, since the last one. NaN: the device has failed.
    double lookTime() const;
    /// What the ray meets first, of bodies as they are deformed and objects, at lookTime().
    /// `direction` of any length but zero. Nothing: it meets nothing, or not finite.
    std::optional<RayHit> castRay(Vec3 origin, Vec3 direction) const;
    /// What hangs together, by body, at lookTime().
    Result<std::vector<Piece>> pieces() const;
    /// Where an object is, at lookTime().
    Result<ObjectState> object(int object) const;
    /// How many bonds have broken, at lookTime().
    Result<int> brokenBonds() const;
    /// A fingerprint of the state, to the bit: for tests, and to find where two runs part. On a GPU
    /// it waits and reads the state.
    Result<std::uint64_t> stateHash() const;
    /// How much there is.
    WorldSize size() const;
    /// The name of the solver.
    std::string_view solver() const;
    /// Sentences about what is not as described: a stiffness that the substep limits, contacts that
    /// were left out for want of room or time.
    std::vector<std::string> notes() const;

    /// For Sunder's own parts.
    struct Impl;
    /// For Sunder's own parts.
    Impl& impl() const { return *impl_; }

  private:
    explicit World(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace sunder
