// Contact between two spheres of different cells: src/core/contact.hpp says what and why.
#include "shared/constants.h"

// What the law asks of a cell.
struct ContactSide {
    float mass;         // kg, of the cell
    float damping;      // α
    float friction;     // μ
    float radius;       // m
    float crowd;        // pairs close by
    float restitution;  // e
};

// s: when two spheres touch, 0 where they do now; more than h where they do not within a step, or are slow enough to be found
// overlapping. x: one's centre less the other's, m; v likewise, m/s; radii: their sum, m.
float touchTime(vec3 x, vec3 v, float radii, float h) {
    float apart = dot(x, x) - radii * radii;
    if (apart < 0.0) return 0.0;
    float along = dot(x, v), squared = dot(v, v), way = kSweptWay * radii;
    float root = along * along - squared * apart;
    bool meets = along < 0.0 && h * h * squared > way * way && root >= 0.0;
    return meets ? apart / (sqrt(root) - along) : 2.0 * h;
}

// m: how near the centres come within that time.
float closestApproach(vec3 x, vec3 v, float time) {
    float squared = dot(v, v);
    return length(x + (squared > 0.0 ? clamp(-dot(x, v) / squared, 0.0, time) : 0.0) * v);
}

// Force on sphere A from sphere B, N. x: A's centre less B's, m; v likewise, m/s; time: touchTime(). stop: N, the force of
// constraint for the whole cell, or 0. way: n, or 0 where it is what it always is; pushSpeed: no more than what pushes them to
// that, m/s, or -1, as for all but bodies that overlap as the world begins.
vec3 contactForce(ContactSide a, ContactSide b, vec3 x, vec3 v, float time, bool neighbours, vec3 stop, vec3 way, float pushSpeed,
                  float h) {
    float radii = a.radius + b.radius;
    x += time * v;
    float d = length(x);
    float overlap = time > 0.0 ? 0.0 : radii - d;
    vec3 n = d > 1.0e-9 ? x / d : vec3(0.0, 1.0, 0.0);
    if (way != vec3(0.0)) n = way;
    float crowd = max(1.0, max(a.crowd, b.crowd));
    float M = a.mass * b.mass / (a.mass + b.mass) / crowd;
    float separating = dot(v, n);
    float f;
    if (neighbours) {
        float parting = max(kPartingTime, kInelasticDamping * h / kContactStiffness);
        f = kInelasticDamping * M / h * (overlap / parting - separating);
    } else {
        float touching = min(1.0, overlap / max(h * abs(separating), 1.0e-12));
        f = M / h * (kContactStiffness / h * overlap - 0.5 * (a.damping + b.damping) * touching * separating);
        if (h * length(v) > kSweptWay * radii) f = max(f, -(1.0 + 0.5 * (a.restitution + b.restitution)) * M / h * separating);
    }
    vec3 hold = vec3(0.0);
    if (stop != vec3(0.0) && !neighbours && time == 0.0) {
        stop /= crowd;
        f = max(f, 0.0) + kConstraintShare * dot(stop, n);
        hold = stop - dot(stop, n) * n;
    }
    if (pushSpeed >= 0.0) f = min(f, kInelasticDamping * M / h * (pushSpeed - separating));
    f = max(f, 0.0);
    vec3 drag = hold - kFrictionRate * M / h * (v - separating * n);
    float size = length(drag), most = 0.5 * (a.friction + b.friction) * f;
    return f * n + (size > most ? most / size : 1.0) * drag;
}
