// Contact between two spheres of different cells: src/core/contact.hpp says what and why.
#include "physics/contact_constants.glsl"

const float kFrictionRate = 0.3;
const float kInelasticDamping = 0.6;
const float kCrowdGap = 0.1; // radii

// What the law asks of a cell.
struct ContactSide {
    float mass;      // kg, of the cell
    float damping;   // α
    float friction;  // μ
    float radius;    // m
    float crowd;     // pairs close by
};

// Force on sphere A from sphere B, N. x: A's centre less B's, m; v likewise, m/s. way: n, or 0 where it is what it always is;
// pushSpeed: no more than what pushes them to that, m/s, or -1, as for all but bodies that overlap as the world begins.
vec3 contactForce(ContactSide a, ContactSide b, vec3 x, vec3 v, bool neighbours, vec3 way, float pushSpeed, float h) {
    float d = length(x);
    float overlap = a.radius + b.radius - d;
    if (overlap <= 0.0) return vec3(0.0);
    vec3 n = d > 1.0e-9 ? x / d : vec3(0.0, 1.0, 0.0);
    if (way != vec3(0.0)) n = way;
    float M = a.mass * b.mass / (a.mass + b.mass) / max(1.0, max(a.crowd, b.crowd));
    float separating = dot(v, n);
    float f;
    if (neighbours) {
        float parting = max(kPartingTime, kInelasticDamping * h / kContactStiffness);
        f = kInelasticDamping * M / h * (overlap / parting - separating);
    } else {
        float touching = min(1.0, overlap / max(h * abs(separating), 1.0e-12));
        f = M / h * (kContactStiffness / h * overlap - 0.5 * (a.damping + b.damping) * touching * separating);
    }
    if (pushSpeed >= 0.0) f = min(f, kInelasticDamping * M / h * (pushSpeed - separating));
    f = max(f, 0.0);
    vec3 sliding = v - separating * n;
    float speed = length(sliding);
    float friction = min(0.5 * (a.friction + b.friction) * f, kFrictionRate * M / h * speed);
    return f * n - (speed > 0.0 ? friction / speed : 0.0) * sliding;
}
