// Contact forces, one fragment per sphere. CORNERS: added to those on the corners of its cell, whose only sphere it is.
// IMPULSES: not the forces, but how hard it is pushed and by whom.
#include "contact/sphere_texel.glsl"
#include "incidents/rank.glsl"
#include "physics/contact.glsl"
#if PARTINGS
#include "contact/parting.glsl"
#endif

uniform sampler2DArray partners;   // contact/search.frag
uniform sampler2DArray summaries;  // of that, layer 0, per cell
uniform samplerBuffer strengths;   // w: friction
#if UNEQUAL
uniform sampler2DArray freeMotions;  // contact/free.frag
#endif
uniform float stepSize;            // s

#if IMPULSES
layout(location = 0) out vec4 pushed;  // x: N·s, blended by addition; w: rankOf(), by MAX
#elif CORNERS
layout(location = 0) out vec4 forces[8];  // N, blended by addition
#else
layout(location = 0) out vec4 force;  // N
#endif

ContactSide sideOf(int cell, float radius) {
    uvec4 record = cellRecord(cell);
    return ContactSide(8.0 * cornerMass(record), uintBitsToFloat(record.w), texelFetch(strengths, cell).w, radius,
                       texelFetch(summaries, ivec3(texelAddress(cell), 0), 0).y,
                       float(record.x >> SUNDER_CELL_RESTITUTION_BIT) / 255.0);
}

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int count = int(texelFetch(partners, ivec3(texel, 0), 0).x);
    if (count == 0) discard;
    int self = fragmentSphere();
    vec4 centre = texelFetch(spheres, ivec3(texel, 0), 0);
    vec3 velocity = texelFetch(spheres, ivec3(texel, 1), 0).xyz;
    ContactSide own = sideOf(cellOf(self), centre.w);
#if UNEQUAL
    vec4 free = texelFetch(freeMotions, ivec3(texel, 0), 0);
#endif
    vec3 sum = vec3(0.0);
#if IMPULSES
    float total = 0.0, hardest = 0.0;
#endif
    vec4 some = vec4(0.0);  // of the partners, the next one first
    for (int p = 0; p < count; ++p) {
        some = (p & 3) == 0 ? texelFetch(partners, ivec3(texel, 1 + (p >> 2)), 0) : some.yzwx;
        int other = int(abs(some.x)) - 1;
        ivec2 address = sphereAddress(other);
        vec4 theirs = texelFetch(spheres, ivec3(address, 0), 0);
        vec3 apart = centre.xyz - theirs.xyz;
        vec3 closing = velocity - texelFetch(spheres, ivec3(address, 1), 0).xyz;
        float time = touchTime(apart, closing, centre.w + theirs.w, stepSize);
        if (time <= stepSize) {
            // Both spheres of a pair work out the same numbers: the lower one's less the higher one's.
            float sign_ = self < other ? 1.0 : -1.0;
            vec3 stop = vec3(0.0);
#if UNEQUAL
            vec4 otherFree = texelFetch(freeMotions, ivec3(address, 0), 0);
            float inverse_ = free.w + otherFree.w;
            if (inverse_ > 0.0) stop = sign_ * (otherFree.xyz - free.xyz) / inverse_;  // or neither can move
#endif
            vec3 way = vec3(0.0);
            float pushSpeed = -1.0;
#if PARTINGS
            if (self < other) partingOf(self, other, centre.xyz, theirs.xyz, way, pushSpeed);
            else partingOf(other, self, theirs.xyz, centre.xyz, way, pushSpeed);
#endif
            vec3 force_ = contactForce(own, sideOf(cellOf(other), theirs.w), sign_ * apart, sign_ * closing, time, some.x < 0.0,
                                       stop, way, pushSpeed, stepSize);
            sum += sign_ * force_;
#if IMPULSES
            float impulse = stepSize * length(force_);
            total += impulse;
            if (impulse > 0.0) hardest = max(hardest, rankOf(impulse, uint(cellOf(other))));
#endif
        }
    }
#if IMPULSES
    pushed = vec4(total, 0.0, 0.0, hardest);
#elif CORNERS
    for (int k = 0; k < 8; ++k) forces[k] = vec4(0.125 * sum, 0.0);
#else
    force = vec4(sum, 0.0);
#endif
}
