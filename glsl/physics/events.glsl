// Pushes (src/core/event.hpp). A node is in the patch of an event of one body by the same single-precision operations as
// insidePatch() in src/core/event.cpp, so every solver picks the same nodes.
#include "shared/layout.h"

uniform samplerBuffer events;  // EventRecord, behind what says where each body's are

// Share of step number `step_` of this frame in which an event acts.
float eventWeight(vec4 time, float step_) {
    return clamp(min(time.y, step_ + 1.0) - max(time.x, step_), 0.0, 1.0);
}

// m/s², of a node at rest position `rest`, by the events of one body.
vec3 patchAcceleration(int body, vec3 rest, float step_) {
    vec3 sum = vec3(0.0);
    vec2 range = texelFetch(events, 1 + body).xy;
    for (int i = 0; i < int(range.y); ++i) {
        int at = int(range.x) + SUNDER_EVENT_TEXELS * i;
        float weight = eventWeight(texelFetch(events, at + 2), step_);
        if (weight == 0.0) continue;
        vec4 patch_ = texelFetch(events, at);
        precise vec3 d = rest - patch_.xyz;
        precise float squared = d.x * d.x + d.y * d.y + d.z * d.z;
        precise float limit = patch_.w * patch_.w;
        if (squared <= limit) sum += weight * texelFetch(events, at + 1).xyz;
    }
    return sum;
}

// m/s², of a node that is at `place` now, by the events of every body.
vec3 blastAcceleration(vec3 place, float step_) {
    vec3 sum = vec3(0.0);
    vec2 range = texelFetch(events, 0).xy;
    for (int i = 0; i < int(range.y); ++i) {
        int at = int(range.x) + SUNDER_EVENT_TEXELS * i;
        vec4 time = texelFetch(events, at + 2);
        float weight = eventWeight(time, step_);
        if (weight == 0.0) continue;
        vec4 ball = texelFetch(events, at);
        vec3 away = place - ball.xyz;
        float squared = dot(away, away), limit = ball.w * ball.w;
        if (squared >= limit) continue;
        vec4 push_ = texelFetch(events, at + 1);
        vec3 acceleration = push_.xyz;
        if (squared > 0.0) acceleration += push_.w * inversesqrt(squared) * away;
        sum += weight * (time.z > 0.0 ? 1.0 - squared / limit : 1.0) * acceleration;
    }
    return sum;
}

// Acceleration, m/s², of a node of a body during step number `step_` of this frame. displacement: m, from rest.
vec3 eventAcceleration(int body, vec3 rest, vec3 displacement, float step_) {
    return patchAcceleration(body, rest, step_) + blastAcceleration(rest + displacement, step_);
}
