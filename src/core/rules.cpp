#include "core/rules.hpp"

#include "core/cell.hpp"
#include "core/limits.hpp"

namespace sunder::core {
namespace {

constexpr Range kCoordinate{-kMaxLength, kMaxLength, "m"};
constexpr Range kTime{0, kMaxTime, "s"};
constexpr Range kSpeed{-1e4, 1e4, "m/s"};
constexpr Range kSpin{-1e4, 1e4, "rad/s"};
constexpr Range kEdge{1e-3, 1e3, "m"};
constexpr Range kFriction{0, 10};
constexpr double kMostCells = static_cast<double>(kMaxCells);

using M = Material;
constexpr Rule<M> kMaterial[] = {
    {"young_modulus",
     {1, 1e12, "Pa"},
     &M::youngModulus,
     "Stiffness. Higher: bends less and rings faster; more than a step can carry is limited, and "
     "said so."},
    {"poisson_ratio",
     {0, 0.5, "1", false, true},
     &M::poissonRatio,
     "How much it bulges sideways when squeezed. Towards 0.5 it keeps its volume."},
    {"density",
     {0.001, 1e5, "kg/m³"},
     &M::density,
     "Mass per volume. Higher: slower waves, and the same push moves it less."},
    {"damping",
     {0, 1e3, "1/s"},
     &M::damping,
     "Drag. Higher: swinging and flying pieces lose speed sooner."},
    {"gravity",
     {-100, 100},
     &M::gravity,
     "Factor on the scene's gravity. 0 floats, negative rises."},
    {"max_stress",
     {0, 1e15, "Pa", true},
     &M::maxStress,
     "Stress at which a cell leaves all its neighbours, where fracture is 'cell'. Higher: harder "
     "to break."},
    {"strength",
     {0, 1e15, "Pa", true},
     &M::strength,
     "Traction at which faces with normal x, y, z start to take damage, where fracture is 'bond'. "
     "Higher: harder to break."},
    {"boundary_strength",
     {0, 1e15, "Pa", true},
     &M::boundaryStrength,
     "The same between two chunks. Lower: chunks come apart whole."},
    {"damage_length",
     {1e-6, 100, "m"},
     &M::damageLength,
     "Length of material that a crack must overload before it opens. Longer: tougher, less dust."},
    {"shear_weight",
     {0, 10},
     &M::shearWeight,
     "How much shear counts beside pull. Higher: sliding breaks it too."},
    {"internal_friction",
     {0, 10},
     &M::internalFriction,
     "How well pressed faces hold against shear. Higher: they hold better."},
    {"friction", {0, 10}, &M::friction, "Friction between pieces. Higher: heaps stand steeper."},
    {"restitution",
     {0, 1},
     &M::restitution,
     "Share of speed that is kept after a hit. Higher: pieces bounce."},
    {"spread", {0, 1}, &M::spread, "Scatter of strength from face to face. Higher: cracks wander."},
    {"noise_length",
     {0, 100, "m"},
     &M::noiseLength,
     "Wave length of strong and weak zones. 0: none."},
    {"noise_amplitude", {0, 0.95}, &M::noiseAmplitude, "How much strong and weak zones differ."},
    {"cluster_size",
     {0, 1000, "m"},
     &M::clusterSize,
     "Mean size of a chunk along x, y, z. 0: it reaches through the whole wall."},
    {"avg_display_section_width",
     {0.001, 100, "m"},
     &M::avgDisplaySectionWidth,
     "Length of a horizontal edge on which horiz_edge_frequency points come. Smaller: finer "
     "splinters."},
    {"avg_display_section_height",
     {0.001, 100, "m"},
     &M::avgDisplaySectionHeight,
     "Length of a vertical edge on which vert_edge_frequency points come. Smaller: finer "
     "splinters."},
    {"rand_display_section_width",
     {0, 100, "m"},
     &M::randDisplaySectionWidth,
     "Corners of torn pieces lie at random by up to half of this to either side. Larger: less "
     "regular."},
    {"rand_display_section_height",
     {0, 100, "m"},
     &M::randDisplaySectionHeight,
     "Corners of torn pieces lie at random by up to half of this up or down. Larger: less "
     "regular."},
    {"horiz_edge_frequency",
     {0, 20},
     &M::horizEdgeFrequency,
     "Points added to a level torn edge. More: finer splinters."},
    {"horiz_edge_amplitude",
     {0, 100, "m"},
     &M::horizEdgeAmplitude,
     "How far level torn edges zig-zag."},
    {"vert_edge_frequency",
     {0, 20},
     &M::vertEdgeFrequency,
     "Points added to an upright torn edge. More: finer splinters."},
    {"vert_edge_amplitude",
     {0, 100, "m"},
     &M::vertEdgeAmplitude,
     "How far upright torn edges zig-zag."},
    {"joint_width",
     {0, 1, "m"},
     &M::jointWidth,
     "Mortar between bricks, groove between planks; broken edges stay within it."},
    {"colour", {0, 1}, &M::colour, "Colour of the outside, linear red, green, blue."},
    {"inside_colour",
     {0, 1},
     &M::insideColour,
     "Colour of what a break bares, linear red, green, blue."},
    {"transparency",
     {0, 1},
     &M::transparency,
     "Share of light that passes straight through a face. 0: opaque."},
};

using B = BodyDescription;
constexpr Rule<B> kBody[] = {
    {"size", kEdge, &B::size, "Width, height and thickness."},
    {"cells",
     {1, kMostCells},
     &B::cells,
     "Cells along x, y, z. More: finer pieces, slower; the shortest edge limits the stiffness."},
    {"position", kCoordinate, &B::position, "Centre of the bottom face."},
};

using R = RegionDescription;
constexpr Rule<R> kRegion[] = {
    {"from", {0, kMostCells}, &R::from, "The first cell along x, y, z, counted from 0."},
    {"to", {0, kMostCells}, &R::to, "The last cell along x, y, z, which belongs to it."},
};

using E = EventDescription;
constexpr std::array<Rule<E>, 5> eventTable(std::string_view unit) {
    return {{
        {"time", kTime, &E::time, "When it begins."},
        {"point", kCoordinate, &E::point,
         "Middle of the patch, from the body's position along its own axes."},
        {"radius",
         {0, kMaxLength, "m", true},
         &E::radius,
         "Size of the patch: all nodes within are pushed."},
        {"vector",
         {-1e12, 1e12, unit},
         &E::vector,
         "What it gives to the patch, and which way in the world."},
        {"duration",
         {0, kMaxTime, "s", true},
         &E::duration,
         "Time over which it is spread evenly. Longer: less dust."},
    }};
}
constexpr auto kImpulse = eventTable("N·s"), kForce = eventTable("N"),
               kVelocity = eventTable("m/s");

constexpr Rule<E> kBlast[] = {
    {"outward", {-1e12, 1e12, "m/s"}, &E::outward, "Away from the middle, on top of `vector`."},
};

using O = ObjectDescription;
constexpr Rule<O> kObject[] = {
    {"mass", {1e-6, 1e9, "kg"}, &O::mass, "How heavy it is, unless it is fixed."},
    {"velocity", kSpeed, &O::velocity, "How it moves at first."},
    {"spin", kSpin, &O::spin, "How it turns at first, about the world's axes."},
    {"drag", {0, 1e3, "1/s"}, &O::drag, "Drag on motion and spin. Higher: it loses speed sooner."},
    {"position", kCoordinate, &O::position,
     "Place of its centre. Without one it is not there until it is thrown."},
    {"hung_from", kCoordinate, &O::hungFrom,
     "Where its chain begins, which is as long as the way to its centre at first."},
    {"friction", kFriction, &O::friction, "Coulomb friction; with anything else the mean counts."},
    {"restitution", {0, 1}, &O::restitution, "Share of speed that is kept after a hit."},
    {"colour", {0, 1}, &O::colour, "Linear red, green, blue."},
};

constexpr Rule<O> kRound[] = {
    {"radius", kEdge,
     Property<O, double>{[](const O& o) { return o.halfSize[0]; },
                         [](O& o, const double& radius) { o.halfSize.setConstant(radius); }},
     "Of a ball, or of a capsule across its axis."},
};
constexpr Rule<O> kBox[] = {
    {"size", kEdge,
     Property<O, Vec3>{[](const O& o) { return Vec3(2 * o.halfSize); },
                       [](O& o, const Vec3& size) { o.halfSize = size / 2; }},
     "Edges along x, y, z."},
};
constexpr Property<O, double> kLength{[](const O& o) { return 2 * o.halfSize[1]; },
                                      [](O& o, const double& whole) { o.halfSize[1] = whole / 2; }};

using T = ThrowDescription;
constexpr Rule<T> kThrow[] = {
    {"time", kTime, &T::time, "When it is thrown."},
    {"from", kCoordinate, &T::from, "Where its centre is then."},
    {"velocity", kSpeed, &T::velocity, "How it moves then."},
    {"spin", kSpin, &T::spin, "How it turns then, about the world's axes."},
};

using Room = RoomDescription;
constexpr Rule<Room> kRoom[] = {
    {"x", kCoordinate, &Room::x, "Where the walls across x stand: low, high."},
    {"z", kCoordinate, &Room::z, "Where the walls across z stand: low, high."},
    {"friction", kFriction, &Room::friction, "Coulomb friction of walls and ceiling."},
    {"ceiling", {0, kMaxLength, "m", true}, &Room::ceiling, "Height of the ceiling, if any."},
};

using W = WorldDescription;
constexpr Rule<W> kWorld[] = {
    {"gravity", {-1000, 1000, "m/s²"}, &W::gravity, "What everything falls with."},
    {"step",
     {1e-6, kMaxStep, "s"},
     &W::step,
     "One substep. Shorter: carries stiffer materials and faster hits, slower."},
};
constexpr Rule<W> kSolver[] = {
    {"fracture_interval",
     {0, 100},
     &W::fractureInterval,
     "Substeps from one fracture update to the next; 0: in which a wave crosses a few cells."},
};
constexpr Rule<W> kGround[] = {
    {"friction", kFriction, &W::groundFriction, "Coulomb friction of the ground."},
};
constexpr Rule<W> kContact[] = {
    {"parting_speed",
     {0.2, 100, "m/s"},
     &W::partingSpeed,
     "What overlaps, other than by a hit, parts no faster than this."},
};

}  // namespace

std::span<const Rule<Material>> materialRules() {
    return kMaterial;
}

std::span<const Rule<BodyDescription>> bodyRules() {
    return kBody;
}

std::span<const Rule<RegionDescription>> regionRules() {
    return kRegion;
}

std::span<const Rule<EventDescription>> eventRules(EventDescription::Kind kind) {
    switch (kind) {
        case EventDescription::Kind::Impulse:
            return kImpulse;
        case EventDescription::Kind::Force:
            return kForce;
        case EventDescription::Kind::Velocity:
            return kVelocity;
    }
    return {};
}

std::span<const Rule<EventDescription>> blastRules() {
    return kBlast;
}

std::span<const Rule<ObjectDescription>> objectRules() {
    return kObject;
}

std::span<const Rule<ObjectDescription>> shapeRules(ObjectShape shape) {
    if (shape == ObjectShape::Box) return kBox;
    return kRound;
}

Rule<ObjectDescription> lengthRule(double radius) {
    return {"length",
            {2 * radius, 2 * kEdge.max, "m"},
            kLength,
            "From end to end of a capsule, along its y axis."};
}

std::span<const Rule<ThrowDescription>> throwRules() {
    return kThrow;
}

std::span<const Rule<RoomDescription>> roomRules() {
    return kRoom;
}

std::span<const Rule<WorldDescription>> worldRules() {
    return kWorld;
}

std::span<const Rule<WorldDescription>> solverRules() {
    return kSolver;
}

std::span<const Rule<WorldDescription>> groundRules() {
    return kGround;
}

std::span<const Rule<WorldDescription>> contactRules() {
    return kContact;
}

}  // namespace sunder::core
