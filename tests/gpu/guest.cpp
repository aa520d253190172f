#include "gpu/guest.hpp"

#include "support/object_worlds.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

const World& guestWorld() {
    static const World world = [] {
        Material material = brittle();
        material.friction = 0.5;
        WorldDescription d = block({5, 4, 2}, material);
        d.bodies[0].anchors = {Side::Bottom};
        BodyDescription slab = d.bodies[0];
        slab.name = "slab";
        slab.anchors = {};
        slab.cells = {3, 1, 2};
        slab.size = {0.6, 0.1, 0.2};
        slab.position = {0, 0.401, 0};
        d.bodies.push_back(slab);
        d.gravity = {0, -9.81, 0};
        d.ground = true;
        d.contact = true;
        d.step = 1.0 / 600;  // ten steps to a look for incidents and for rest
        d.events = {hit(0, {0.1, 0.3, 0.1}, {0, 0, -9}), hit(1, {0.1, 0, 0.1}, {0, -6, 0})};
        d.objects = {ball(0.1, 3, {0.15, 0.2, 0.205}, {0, 0, -10})};
        return World(d);
    }();
    return world;
}
