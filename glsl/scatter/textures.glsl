// Addresses in the scatter solver's float textures.
#include "physics/lattice.glsl"

// The SUNDER_STRESS_TEXELS texels of a tetrahedron: (eigenvector, eigenvalue), (T_xx, T_yy, T_zz, –), (T_xy, T_yz, T_zx, –).
#define SUNDER_STRESS_PRINCIPAL 0
#define SUNDER_STRESS_NORMAL 1
#define SUNDER_STRESS_SHEAR 2

// Clip-space position whose point covers exactly the texel `index` of a target `height` rows high.
vec4 texelPosition(int index, float height) {
    vec2 texel = vec2(texelAddress(index)) + 0.5;
    return vec4(texel / vec2(float(1 << textureShift), height) * 2.0 - 1.0, 0.0, 1.0);
}
