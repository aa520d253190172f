// Pushes on patches of bodies. A node is in an event's patch by the same single-precision operations as insidePatch() in
// src/core/world.cpp, so every solver picks the same nodes.
#include "shared/layout.h"

uniform samplerBuffer events;  // SUNDER_EVENT_TEXELS per event, sorted by body

// Acceleration, m/s², of a node at rest position `rest` during step number `step_` of this frame. range: first event, count.
vec3 eventAcceleration(vec2 range, vec3 rest, float step_) {
    vec3 sum = vec3(0.0);
    int first = int(range.x), end = first + int(range.y);
    for (int i = first; i < end; ++i) {
        vec4 time = texelFetch(events, SUNDER_EVENT_TEXELS * i + 2);
        float weight = clamp(min(time.y, step_ + 1.0) - max(time.x, step_), 0.0, 1.0);
        if (weight == 0.0) continue;
        vec4 patch_ = texelFetch(events, SUNDER_EVENT_TEXELS * i);
        precise vec3 d = rest - patch_.xyz;
        precise float squared = d.x * d.x + d.y * d.y + d.z * d.z;
        precise float limit = patch_.w * patch_.w;
        if (squared <= limit) sum += weight * texelFetch(events, SUNDER_EVENT_TEXELS * i + 1).xyz;
    }
    return sum;
}
