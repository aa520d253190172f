// What materials look like, by row of the table of laws.
#include "shared/layout.h"

layout(std140) uniform SurfaceLooks {
    SurfaceLook looks[SUNDER_MAX_ELEMENT_LAWS];
};
