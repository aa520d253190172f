// Contact between the spheres of two cells: src/core/contact.hpp says what and why.
#include "physics/lattice.glsl"

const float kContactStiffness = 0.12;
const float kFrictionRate = 0.3;
const float kInelasticDamping = 0.6;
const float kPartingTime = 0.01;  // s
const float kCrowdGap = 0.1; // radii

// A cell's spheres: how many along each axis, radius (m).
struct Proxy {
    ivec3 count;
    float radius;
};

Proxy proxyOf(BodyRecord body) {
    int counts = int(body.events.z);
    return Proxy(ivec3(counts & 15, counts >> 4 & 15, counts >> 8), body.events.w);
}

// One wherever every cell of the world has but one: the compiler then drops what more would take.
int sphereCount(Proxy proxy) {
#if ONE_SPHERE
    return 1;
#else
    return proxy.count.x * proxy.count.y * proxy.count.z;
#endif
}

// Place of a sphere in its cell, 0 to 1.
vec3 spherePlace(Proxy proxy, int sphere) {
#if ONE_SPHERE
    return vec3(0.5);
#endif
    ivec3 n = proxy.count;
    return (vec3(sphere % n.x, sphere / n.x % n.y, sphere / (n.x * n.y)) + 0.5) / vec3(n);
}

// Trilinear weight of a corner at a place in its cell.
float cornerWeight(int corner, vec3 place) {
    vec3 w = mix(1.0 - place, place, vec3(cornerBits(corner)));
    return w.x * w.y * w.z;
}

// What the law asks of a cell.
struct ContactSide {
    float mass;      // kg, of the cell
    float damping;   // α
    float friction;  // μ
    float radius;    // m
    float crowd;     // N
};

// Force on sphere A from sphere B, N. x: A's centre less B's, m; v likewise, m/s.
vec3 contactForce(ContactSide a, ContactSide b, vec3 x, vec3 v, bool neighbours, float h) {
    float d = length(x);
    float overlap = a.radius + b.radius - d;
    if (overlap <= 0.0) return vec3(0.0);
    vec3 n = d > 1.0e-9 ? x / d : vec3(0.0, 1.0, 0.0);
    float M = a.mass * b.mass / (a.mass + b.mass) / max(a.crowd, b.crowd);
    float separating = dot(v, n);
    float f;
    if (neighbours) {
        float parting = max(kPartingTime, kInelasticDamping * h / kContactStiffness);
        f = kInelasticDamping * M / h * (overlap / parting - separating);
    } else {
        float touching = min(1.0, overlap / max(h * abs(separating), 1.0e-12));
        f = M / h * (kContactStiffness / h * overlap - 0.5 * (a.damping + b.damping) * touching * separating);
    }
    f = max(f, 0.0);
    vec3 sliding = v - separating * n;
    float speed = length(sliding);
    float friction = min(0.5 * (a.friction + b.friction) * f, kFrictionRate * M / h * speed);
    return f * n - (speed > 0.0 ? friction / speed : 0.0) * sliding;
}

// Whether both are cells of one body at most one step apart along every axis; and how far from a to b.
bool latticeNeighbours(int a, int b, uvec4 recordA, uvec4 recordB, out ivec3 offset) {
    offset = ivec3(0);
    if (recordA.y != recordB.y) return false;
    ivec4 lattice = ivec4(bodyRecord(bodyOf(recordA)).lattice);
    offset = cellCoordinates(b, lattice) - cellCoordinates(a, lattice);
    return all(lessThanEqual(abs(offset), ivec3(1)));
}
