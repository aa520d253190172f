// How rounded boxes touch: src/core/object_contact.hpp says what and why.
#include "shared/constants.h"
#include "shared/layout.h"

// All points within `radius` of a box.
struct RoundedBox {
    vec3 centre;
    mat3 axes;     // columns, orthonormal
    vec3 half_;    // m, of the core
    float radius;  // m
};

vec3 nearestPoint(RoundedBox box, vec3 x) {
    vec3 local = clamp((x - box.centre) * box.axes, -box.half_, box.half_);
    return box.centre + box.axes * local;
}

struct Touch {
    vec3 normal;  // from the first to the second
    vec3 point;   // m, midway between the surfaces
    float gap;    // m, negative: overlap
};

Touch touchOf(RoundedBox from, RoundedBox to) {
    vec3 x = to.centre, y = nearestPoint(from, x);
    for (int i = 0; i < kProjections; ++i) {
        x = nearestPoint(to, y);
        y = nearestPoint(from, x);
    }
    float radii = from.radius + to.radius;
    vec3 apart = x - y;
    float distance_ = length(apart);
    if (distance_ < 1.0e-3 * radii) {  // the cores meet
        x = to.centre;
        y = nearestPoint(from, x);
        apart = x - y;
        if (length(apart) < 1.0e-3 * radii) apart = x - from.centre;
        distance_ = 0.0;
    }
    Touch touch;
    float size = length(apart);
    touch.normal = size > 1.0e-6 * radii ? apart / size : vec3(0.0, 1.0, 0.0);
    touch.gap = distance_ - radii;
    touch.point = 0.5 * (y + from.radius * touch.normal + x - to.radius * touch.normal);
    return touch;
}

// The second moves at `velocity`, m/s, relative to the first for `h` seconds.
Touch sweptTouch(RoundedBox from, RoundedBox to, vec3 velocity, float h) {
    Touch touch = touchOf(from, to);
    float speed = length(velocity), radii = from.radius + to.radius;
    if (touch.gap <= 0.0 || touch.gap > h * speed || h * speed < 0.1 * radii) return touch;
    vec3 start = to.centre;
    float time = 0.0;
    for (int i = 0; i < kAdvances; ++i) {
        if (touch.gap <= 0.02 * radii) break;
        time += touch.gap / speed;
        if (time > h) {
            touch.gap = 2.0 * speed * h;  // they miss each other
            return touch;
        }
        to.centre = start + time * velocity;
        touch = touchOf(from, to);
    }
    touch.gap = time * max(0.0, -dot(velocity, touch.normal));
    return touch;
}

// So that the touch asks for no more than `speed`, m/s.
void limitDepth(inout Touch touch, float speed, float h) {
    touch.gap = max(touch.gap, -speed * max(kPartingTime, h / kContactStiffness));
}

// Of two boxes whose cores meet: the normal is the axis of one of them on which they are apart soonest.
Touch deepTouch(RoundedBox from, RoundedBox to) {
    vec3 apart = to.centre - from.centre;
    Touch touch;
    touch.point = from.centre + 0.5 * apart;
    touch.gap = -1.0e30;
    for (int i = 0; i < 6; ++i) {
        vec3 n = i < 3 ? from.axes[i] : to.axes[i - 3];
        float along = dot(apart, n);
        float gap = abs(along) - from.radius - to.radius - dot(abs(n * from.axes), from.half_) - dot(abs(n * to.axes), to.half_);
        if (gap <= touch.gap) continue;
        touch.gap = gap;
        touch.normal = along < 0.0 ? -n : n;
    }
    return touch;
}

// The unit vector along one of the cell's axes on which x is out of a whole body soonest, and by how much, m, negative where it
// is out; below, above: m, from the cell's centre to the body's ends.
vec3 wayOut(RoundedBox cell, vec3 below, vec3 above, vec3 x, out float depth) {
    vec3 local = (x - cell.centre) * cell.axes;
    vec3 toLow = local + below, toHigh = above - local;
    float down = min(toLow.x, min(toLow.y, toLow.z)), up = min(toHigh.x, min(toHigh.y, toHigh.z));
    depth = min(down, up);
    vec3 ways = up <= down ? toHigh : -toLow;
    float way = up <= down ? up : -down;
    int axis = ways.x == way ? 0 : ways.y == way ? 1 : 2;
    return (up <= down ? 1.0 : -1.0) * cell.axes[axis];
}

float partingSpeed(float gap, float h) {
    return gap > 0.0 ? -gap / h : -gap / max(kPartingTime, h / kContactStiffness);
}

bool touches(Touch touch, vec3 velocity, float h) { return dot(velocity, touch.normal) < partingSpeed(touch.gap, h); }

// N·s on the second side. yield_: what both sides give way per impulse, 1/kg; x: along the normal, y: across it.
vec3 touchImpulse(Touch touch, vec3 velocity, vec2 yield_, float restitution, float friction, float h) {
    float along = dot(velocity, touch.normal);
    float parting = partingSpeed(touch.gap, h);
    if (along < -kBounceSpeed) parting = max(parting, -restitution * along);
    float push = max(0.0, parting - along) / yield_.x;
    vec3 sliding = velocity - along * touch.normal;
    float speed = length(sliding);
    float drag = min(friction * push, speed / yield_.y);
    return push * touch.normal - (speed > 0.0 ? drag / speed : 0.0) * sliding;
}
