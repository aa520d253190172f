// Mortar between bricks, grooves between planks: computed, not baked, so that they lie where the clusters meet.
#include "draw/clusters.glsl"

struct Joint {
    float coverage;  // 0 to 1, of the pixel
    vec3 slope;      // of the surface where it dips into the joint, height over length along the rest frame's axes
};

// Coverage of a band from −halfWidth to halfWidth by a pixel `footprint` wide at `distance`: a box filter, exact.
float bandCoverage(float distance, float halfWidth, float footprint) {
    float high = min(distance + 0.5 * footprint, halfWidth), low = max(distance - 0.5 * footprint, -halfWidth);
    return clamp((high - low) / footprint, 0.0, 1.0);
}

// Height (m) at `distance` from a joint's middle: a smooth bevel between the joint's bottom and the surface.
float bevelHeight(float distance, float halfWidth, float bevel, float depth) {
    return depth * smoothstep(-0.5 * bevel, 0.5 * bevel, abs(distance) - halfWidth);
}

// At `place` (m), for pixels of `footprint` (m, along each axis), on a face whose rest normal is along `faceAxis`. `wobble`
// (m) moves the joint's edges.
Joint jointAt(SurfaceLook look, vec3 place, vec3 footprint, int faceAxis, float wobble) {
    float halfWidth = 0.5 * look.finish.y;
    float bevel = 0.8 * halfWidth, depth = 0.6 * halfWidth;
    vec3 within = fract(clusterCoordinates(look, place));
    Joint joint = Joint(0.0, vec3(0.0));
    float open = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == faceAxis || look.clusters[axis] == 0.0) continue;
        float side = within[axis] < 0.5 ? 1.0 : -1.0;
        float distance = look.clusters[axis] * (0.5 - abs(within[axis] - 0.5)) + wobble;
        float width = max(footprint[axis], 1e-5);
        open *= 1.0 - bandCoverage(distance, halfWidth, width);
        // The mean over the pixel, in which both sides of a narrow joint cancel out: at its centre alone, bevels narrower than
        // a pixel would come out as dashes.
        float from = side * distance - 0.5 * width, to = side * distance + 0.5 * width;
        joint.slope[axis] =
            (bevelHeight(to, halfWidth, bevel, depth) - bevelHeight(from, halfWidth, bevel, depth)) / width;
    }
    joint.coverage = int(look.clusters.w) == SUNDER_CLUSTERS_NONE ? 0.0 : 1.0 - open;
    if (int(look.clusters.w) == SUNDER_CLUSTERS_NONE) joint.slope = vec3(0.0);
    return joint;
}
