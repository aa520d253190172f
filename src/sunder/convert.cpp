#include "sunder/convert.hpp"

#include <cmath>
#include <type_traits>

namespace sunder {

namespace {

constexpr std::pair<Side, core::Side> kSides[] = {
    {Side::Left, core::Side::Left},     {Side::Right, core::Side::Right},
    {Side::Bottom, core::Side::Bottom}, {Side::Top, core::Side::Top},
    {Side::Back, core::Side::Back},     {Side::Front, core::Side::Front}};

/// Enumerations of the public interface are the inside's, in the same order.
template <class To, class From>
To same(From value) {
    return static_cast<To>(static_cast<int>(value));
}
static_assert(static_cast<int>(ConstitutiveLaw::Corotated) ==
              static_cast<int>(core::ConstitutiveLaw::Corotated));
static_assert(static_cast<int>(FractureMode::Bond) == static_cast<int>(core::FractureMode::Bond));
static_assert(static_cast<int>(ClusterKind::Planks) == static_cast<int>(core::ClusterKind::Planks));
static_assert(static_cast<int>(SurfaceKind::Glass) == static_cast<int>(core::SurfaceKind::Glass));

/// Throws InputError where somebody has put a number into an enumeration that means nothing.
template <class Enumeration>
void checkEnumeration(Enumeration value, Enumeration last, const std::string& what) {
    if (static_cast<int>(value) < 0 || static_cast<int>(value) > static_cast<int>(last))
        throw core::InputError(what + " must be one of its enumeration's values, not " +
                               std::to_string(static_cast<int>(value)));
}

std::vector<core::Side> sidesOf(Side sides, const std::string& body) {
    std::vector<core::Side> result;
    for (const auto& [ours, theirs] : kSides)
        if ((sides & ours) != Side::None) result.push_back(theirs);
    if (static_cast<unsigned>(sides) > 63)
        throw core::InputError(body + "anchors must be made of the values of Side");
    return result;
}

static_assert(static_cast<int>(Object::Shape::Sphere) ==
              static_cast<int>(core::ObjectShape::Sphere));
static_assert(static_cast<int>(Object::Shape::Capsule) ==
              static_cast<int>(core::ObjectShape::Capsule));

core::ObjectDescription describe(const Object& object, int index) {
    const std::string what =
        "object " + (object.name.empty() ? std::to_string(index + 1) : "'" + object.name + "'") +
        ": ";
    checkEnumeration(object.shape, Object::Shape::Capsule, what + "shape");
    core::ObjectDescription d;
    d.name = object.name;
    d.shape = same<core::ObjectShape>(object.shape);
    d.halfSize = toCore(object.size) / 2;
    // Of a ball and a capsule the inside has the radius along every axis but a capsule's own.
    if (object.shape != Object::Shape::Box) d.halfSize[2] = d.halfSize[0];
    if (object.shape == Object::Shape::Sphere) d.halfSize[1] = d.halfSize[0];
    d.mass = object.mass;
    if (object.position) d.position = toCore(*object.position);
    d.orientation = toCore(object.orientation, (what + "orientation").c_str());
    d.velocity = toCore(object.velocity);
    d.spin = toCore(object.spin);
    d.friction = object.friction;
    d.restitution = object.restitution;
    d.drag = object.drag;
    d.fixed = object.isFixed;
    d.kinematic = object.isKinematic;
    if (object.hungFrom) d.hungFrom = toCore(*object.hungFrom);
    d.colour = toCore(object.colour);
    d.mayOverlap = object.mayOverlap;
    return d;
}

Object objectOf(const core::ObjectDescription& d) {
    Object object;
    object.name = d.name;
    object.shape = same<Object::Shape>(d.shape);
    object.size = fromCore(core::Vec3(2 * d.halfSize));
    object.mass = d.mass;
    if (d.position) object.position = fromCore(*d.position);
    object.orientation = fromCore(d.orientation);
    object.velocity = fromCore(d.velocity);
    object.spin = fromCore(d.spin);
    object.friction = d.friction;
    object.restitution = d.restitution;
    object.drag = d.drag;
    object.isFixed = d.fixed;
    object.isKinematic = d.kinematic;
    if (d.hungFrom) object.hungFrom = fromCore(*d.hungFrom);
    object.colour = fromCore(d.colour);
    object.mayOverlap = d.mayOverlap;
    return object;
}

core::BodyDescription describe(const BodyDesc& body, int index) {
    core::BodyDescription d;
    d.name = body.name;
    d.size = toCore(body.size);
    d.cells = toCore(body.cells);
    d.position = toCore(body.position);
    d.orientation =
        toCore(body.orientation, ("body " + std::to_string(index + 1) + ": orientation").c_str());
    d.material = body.material;
    d.anchors = sidesOf(body.anchors, "body " + std::to_string(index + 1) + ": ");
    for (const RegionDesc& region : body.regions)
        d.regions.push_back({toCore(region.from), toCore(region.to), region.material});
    d.mayOverlap = body.mayOverlap;
    d.present = body.present;
    return d;
}

BodyDesc bodyOf(const core::BodyDescription& d) {
    BodyDesc body;
    body.name = d.name;
    body.size = fromCore(d.size);
    body.cells = fromCore(d.cells);
    body.position = fromCore(d.position);
    body.orientation = fromCore(d.orientation);
    body.material = d.material;
    for (const core::Side side : d.anchors)
        for (const auto& [ours, theirs] : kSides)
            if (side == theirs) body.anchors = body.anchors | ours;
    for (const core::RegionDescription& region : d.regions)
        body.regions.push_back({fromCore(region.from), fromCore(region.to), region.material});
    body.mayOverlap = d.mayOverlap;
    body.present = d.present;
    return body;
}

Push pushOf(const core::EventDescription& event, const core::WorldDescription& world) {
    using Kind = core::EventDescription::Kind;
    Push push;
    push.body = event.body;
    core::Vec3 at = event.point;
    if (event.body >= 0) {
        const core::BodyDescription& body = world.bodies[event.body];
        at = body.position + body.orientation * at;
    }
    push.at = fromCore(at);
    push.radius = event.radius;
    (event.kind == Kind::Impulse ? push.impulse
     : event.kind == Kind::Force ? push.force
                                 : push.velocity) = fromCore(event.vector);
    push.outward = event.outward;
    push.falloff = event.falloff;
    push.duration = event.duration;
    push.delay = event.time;
    return push;
}

template <class Value>
void set(Value& to, const Value& from) {
    to = from;
}
void set(core::Vec3& to, const Vec3& from) {
    to = toCore(from);
}
void set(Vec3& to, const core::Vec3& from) {
    to = fromCore(from);
}
template <class To, class From>
requires std::is_enum_v<To>
void set(To& to, From from) {
    to = same<To>(from);
}

/// All fields of a material, either way.
template <class From, class To>
void copyFields(const From& from, To& to) {
    set(to.name, from.name);
    set(to.youngModulus, from.youngModulus);
    set(to.poissonRatio, from.poissonRatio);
    set(to.density, from.density);
    set(to.damping, from.damping);
    set(to.gravity, from.gravity);
    set(to.law, from.law);
    set(to.fracture, from.fracture);
    set(to.maxStress, from.maxStress);
    set(to.strength, from.strength);
    set(to.boundaryStrength, from.boundaryStrength);
    set(to.damageLength, from.damageLength);
    set(to.shearWeight, from.shearWeight);
    set(to.internalFriction, from.internalFriction);
    set(to.spread, from.spread);
    set(to.noiseLength, from.noiseLength);
    set(to.noiseAmplitude, from.noiseAmplitude);
    set(to.clusters, from.clusters);
    set(to.clusterSize, from.clusterSize);
    set(to.friction, from.friction);
    set(to.restitution, from.restitution);
    set(to.avgDisplaySectionWidth, from.avgDisplaySectionWidth);
    set(to.avgDisplaySectionHeight, from.avgDisplaySectionHeight);
    set(to.randDisplaySectionWidth, from.randDisplaySectionWidth);
    set(to.randDisplaySectionHeight, from.randDisplaySectionHeight);
    set(to.horizEdgeFrequency, from.horizEdgeFrequency);
    set(to.horizEdgeAmplitude, from.horizEdgeAmplitude);
    set(to.vertEdgeFrequency, from.vertEdgeFrequency);
    set(to.vertEdgeAmplitude, from.vertEdgeAmplitude);
    set(to.jointWidth, from.jointWidth);
    set(to.surface, from.surface);
    set(to.colour, from.colour);
    set(to.insideColour, from.insideColour);
    set(to.transparency, from.transparency);
}

}  // namespace

Eigen::Quaterniond toCore(const Quat& q, const char* what) {
    const Eigen::Quaterniond turn(q.w, q.x, q.y, q.z);
    if (!(std::abs(turn.norm() - 1) <= 1e-3))
        throw core::InputError(std::string(what) + " must be a quaternion of length 1");
    return turn.normalized();
}

Quat fromCore(const Eigen::Quaterniond& q) {
    return {q.w(), q.x(), q.y(), q.z()};
}

core::Material toCore(const Material& m) {
    const std::string what = "material '" + m.name + "': ";
    checkEnumeration(m.law, ConstitutiveLaw::Corotated, what + "law");
    checkEnumeration(m.fracture, FractureMode::Bond, what + "fracture");
    checkEnumeration(m.clusters, ClusterKind::Planks, what + "clusters");
    checkEnumeration(m.surface, SurfaceKind::Glass, what + "surface");
    core::Material c;
    copyFields(m, c);
    return c;
}

Material fromCore(const core::Material& c) {
    Material m;
    copyFields(c, m);
    return m;
}

core::EventDescription toCore(const Push& push, const std::vector<core::BodyDescription>& bodies) {
    using Kind = core::EventDescription::Kind;
    core::EventDescription event;
    const bool impulse = push.impulse != Vec3{}, force = push.force != Vec3{};
    const bool velocity = push.velocity != Vec3{} || push.outward != 0;
    if (impulse + force + velocity > 1)
        throw core::InputError(
            "a push is given by its velocity, its impulse or its force, not by "
            "several of them");
    event.kind = impulse ? Kind::Impulse : force ? Kind::Force : Kind::Velocity;
    event.vector = toCore(impulse ? push.impulse : force ? push.force : push.velocity);
    event.time = push.delay;
    event.duration = push.duration;
    event.body = push.body;
    event.point = toCore(push.at);
    if (push.body >= 0 && push.body < static_cast<int>(bodies.size())) {
        const core::BodyDescription& body = bodies[push.body];
        event.point = body.orientation.conjugate() * (event.point - body.position);
    }
    event.radius = push.radius;
    event.outward = push.outward;
    event.falloff = push.falloff;
    return event;
}

core::WorldDescription toCore(const WorldDesc& desc) {
    core::WorldDescription d;
    for (const Material& material : desc.materials) d.materials.push_back(toCore(material));
    for (const BodyDesc& body : desc.bodies)
        d.bodies.push_back(describe(body, static_cast<int>(d.bodies.size())));
    for (const Object& object : desc.objects)
        d.objects.push_back(describe(object, static_cast<int>(d.objects.size())));
    for (const Push& push : desc.pushes) d.events.push_back(toCore(push, d.bodies));
    for (const Throw& thrown : desc.throws)
        d.throws.push_back({thrown.time, thrown.object, toCore(thrown.from),
                            toCore(thrown.velocity), toCore(thrown.spin)});
    d.gravity = toCore(desc.gravity);
    d.ground = desc.ground;
    d.groundFriction = desc.groundFriction;
    if (desc.room)
        d.room = core::RoomDescription{{desc.room->minX, desc.room->maxX},
                                       {desc.room->minZ, desc.room->maxZ},
                                       desc.room->friction,
                                       desc.room->ceiling};
    d.contact = desc.contact;
    d.partingSpeed = desc.partingSpeed;
    d.step = desc.substep;
    d.fractureInterval = desc.fractureInterval;
    d.seed = desc.seed;
    return d;
}

WorldDesc fromCore(const core::WorldDescription& d) {
    WorldDesc desc;
    for (const core::Material& material : d.materials) desc.materials.push_back(fromCore(material));
    for (const core::BodyDescription& body : d.bodies) desc.bodies.push_back(bodyOf(body));
    for (const core::ObjectDescription& object : d.objects)
        desc.objects.push_back(objectOf(object));
    for (const core::EventDescription& event : d.events) desc.pushes.push_back(pushOf(event, d));
    for (const core::ThrowDescription& thrown : d.throws)
        desc.throws.push_back({thrown.time, thrown.object, fromCore(thrown.from),
                               fromCore(thrown.velocity), fromCore(thrown.spin)});
    desc.gravity = fromCore(d.gravity);
    desc.ground = d.ground;
    desc.groundFriction = d.groundFriction;
    if (d.room)
        desc.room = RoomDesc{d.room->x[0], d.room->x[1],     d.room->z[0],
                             d.room->z[1], d.room->friction, d.room->ceiling};
    desc.contact = d.contact;
    desc.partingSpeed = d.partingSpeed;
    desc.substep = d.step;
    desc.fractureInterval = d.fractureInterval;
    desc.seed = d.seed;
    return desc;
}

ObjectState fromCore(const core::ObjectState& state, const core::Object& object) {
    return {state.present,
            {fromCore(state.position), fromCore(state.orientation)},
            fromCore(state.velocity),
            fromCore(state.spin(object))};
}

}  // namespace sunder
