// What materials look like, by row of the table of laws.
#include "shared/layout.h"

// SurfacePoint's seed for a body.
float bodySeed(uint body) {
    return fract(0.618034 * float(body));
}

layout(std140) uniform SurfaceLooks {
    SurfaceLook looks[SUNDER_MAX_ELEMENT_LAWS];
};
