// What a world is, as one number: World::fingerprint().
#include "core/fnv.hpp"
#include "core/world.hpp"

namespace sunder::core {
namespace {

class Hash {
  public:
    template <class... Numbers>
    void add(const Numbers&... numbers) {
        (one(numbers), ...);
    }
    std::uint64_t value() const { return hash_.value(); }

  private:
    template <class Number>
    void one(const Number& number) {
        hash_.add(number);
    }
    void one(const std::optional<double>& number) { add(number.has_value(), number.value_or(0)); }
    void one(const Vec3& v) { add(v[0], v[1], v[2]); }
    void one(const IVec3& v) { add(v[0], v[1], v[2]); }
    void one(const Eigen::Vector3f& v) { add(v[0], v[1], v[2]); }
    void one(const std::array<double, 2>& pair) { add(pair[0], pair[1]); }

    Fnv1a hash_;
};

void addWhole(Hash& hash, const World& world) {
    const WorldDescription& d = world.description();
    hash.add(d.gravity, d.ground, d.groundFriction, d.contact, d.partingSpeed, d.step,
             world.fractureInterval(), d.room.has_value());
    if (d.room) hash.add(d.room->x, d.room->z, d.room->friction, d.room->ceiling);
    hash.add(world.bodies().size(), world.laws().size(), world.events().size(),
             world.objects().size(), world.throws().size(), world.partings().size());
}

void addBodies(Hash& hash, const World& world) {
    for (std::size_t i = 0; i < world.bodies().size(); ++i) {
        const Body& body = world.bodies()[i];
        hash.add(body.cells, body.cellSize, body.origin, body.drag, body.gravity, body.calmest,
                 world.description().bodies[i].anchors.size(),
                 world.description().bodies[i].present);
    }
    for (const ElementLaw& law : world.laws()) {
        const Material& m = world.description().materials[law.material];
        hash.add(law.cellSize, law.lambda, law.mu, law.stressScale, law.damageTime, law.maxStress,
                 law.suddenTraction, law.restitution, law.contactDamping, law.hotViscosity,
                 law.largestStress, static_cast<int>(m.law), static_cast<int>(m.fracture),
                 m.shearWeight, m.internalFriction, m.friction);
    }
    for (const Parting& parting : world.partings())
        hash.add(parting.a, parting.b, parting.low, parting.high, parting.way);
}

/// A body may stand in any direction: two of a cell's corners say which.
void addCells(Hash& hash, const World& world) {
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        hash.add(world.lawOf(cell));
        if (!world.present(cell)) continue;
        const int first = kCorners * cell;
        hash.add(world.nodeMass(first), world.restPosition(first),
                 world.restPosition(first + kCorners - 1));
        int anchored = 0;
        for (int corner = 0; corner < kCorners; ++corner)
            anchored |= world.anchored(first + corner) << corner;
        hash.add(anchored);
        for (int axis = 0; axis < kBondsPerCell; ++axis)
            hash.add(world.bondStrength(kBondsPerCell * cell + axis));
    }
}

void addThings(Hash& hash, const World& world) {
    for (const Event& event : world.events())
        hash.add(event.body, event.point, event.radius, event.acceleration, event.outward,
                 event.falloff, event.start, event.end);
    for (const Object& object : world.objects())
        hash.add(object.core, object.radius, object.inverseMass, object.inverseInertia,
                 object.friction, object.restitution, object.drag, object.chain, object.hungFrom);
    for (const Throw& thrown : world.throws())
        hash.add(thrown.step, thrown.object, thrown.state.position,
                 Vec3(thrown.state.orientation.vec()), thrown.state.velocity,
                 thrown.state.angularMomentum);
}

}  // namespace

std::uint64_t World::findFingerprint() const {
    Hash hash;
    addWhole(hash, *this);
    addBodies(hash, *this);
    addCells(hash, *this);
    addThings(hash, *this);
    return hash.value();
}

}  // namespace sunder::core
