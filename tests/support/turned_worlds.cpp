#include "support/turned_worlds.hpp"

using namespace sunder::core;

WorldDescription turnedWorld(WorldDescription d, const Mat3& turn) {
    const Eigen::Quaterniond q(turn);
    const auto orient = [&](Eigen::Quaterniond& orientation) {
        orientation = (q * orientation).normalized();
    };
    const auto move = [&](Vec3& v) { v = turn * v; };
    for (BodyDescription& body : d.bodies) {
        move(body.position);
        orient(body.orientation);
    }
    for (EventDescription& event : d.events) {
        move(event.vector);
        if (event.body == kEveryBody) move(event.point);
    }
    for (ObjectDescription& object : d.objects) {
        if (object.position) move(*object.position);
        if (object.hungFrom) move(*object.hungFrom);
        orient(object.orientation);
        move(object.velocity);
        move(object.spin);
    }
    for (ThrowDescription& thrown : d.throws)
        for (Vec3* v : {&thrown.from, &thrown.velocity, &thrown.spin}) move(*v);
    move(d.gravity);
    return d;
}

State turnedState(State state, const Mat3& turn) {
    const auto move = [&](Vec3& v) { v = turn * v; };
    for (auto* field : {&state.displacement, &state.velocity})
        for (Vec3& v : *field) move(v);
    for (ObjectState& object : state.objects) {
        for (Vec3* v : {&object.position, &object.velocity, &object.angularMomentum}) move(*v);
        object.orientation = (Eigen::Quaterniond(turn) * object.orientation).normalized();
    }
    return state;
}
