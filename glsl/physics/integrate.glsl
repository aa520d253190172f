// One step of symplectic Euler for one node, then the ground.
#include "shared/layout.h"

uniform float stepSize;  // h, s
uniform vec2 ground;     // x: 1 where there is a floor at y = 0; y: Coulomb coefficient

// acceleration: m/s², of the joined group, gravity and events included. restY: m.
void integrateNode(inout vec3 displacement, inout vec3 velocity, vec3 acceleration, float drag, float speedLimit,
                   float restY) {
    velocity = velocity * drag + stepSize * acceleration;
    float speed = length(velocity);
    if (speed > speedLimit) velocity *= speedLimit / speed;
    precise vec3 next = displacement + stepSize * velocity;
    precise float height = restY + next.y;
    if (ground.x > 0.0 && height < 0.0) {
        // The ground takes all of v_y; Coulomb friction takes at most μ times as much of the rest.
        float tangential = length(velocity.xz);
        float taken = ground.y * max(0.0, -velocity.y);
        float kept = tangential > taken ? 1.0 - taken / tangential : 0.0;
        velocity = vec3(kept * velocity.x, 0.0, kept * velocity.z);
        next = vec3(displacement.x + stepSize * velocity.x, -restY, displacement.z + stepSize * velocity.z);
    }
    displacement = next;
}
