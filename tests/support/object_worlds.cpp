#include "support/object_worlds.hpp"

#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

ObjectDescription ball(double radius, double mass, const Vec3& position, const Vec3& velocity) {
    ObjectDescription object;
    object.halfSize.setConstant(radius);
    object.mass = mass;
    object.position = position;
    object.velocity = velocity;
    object.drag = 0;
    return object;
}

ObjectDescription shaped(ObjectShape shape, const Vec3& halfSize, double mass, const Vec3& position,
                         const Vec3& velocity) {
    ObjectDescription object = ball(0.1, mass, position, velocity);
    object.shape = shape;
    object.halfSize = halfSize;
    return object;
}

WorldDescription objectsOnly() {
    WorldDescription d = block({1, 1, 1}, softElastic());
    d.bodies[0].position = {0, 0, 100};
    d.bodies[0].anchors = {Side::Left, Side::Right};
    d.contact = true;
    return d;
}
