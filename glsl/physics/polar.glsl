// Rotation R of the polar decomposition G = R·S: the rotation that maximises tr(Rᵀ·G), also for inverted G.
//
// Starts from Gram–Schmidt and turns R by ω, R ← R·exp[ω]. Near the maximum ω solves Newton's equation
// (tr(S)·I − S)·ω = a with a the axial vector of RᵀG, which doubles the digits each time; where that matrix is not safely
// positive definite (flat or inverted elements) the step of Müller et al. 2016, "A Robust Method to Extract the Rotational
// Part of Deformations", climbs instead. By itself it would leave 1/81 of the first error after four turns: a skew stress,
// which does not keep angular momentum.

vec3 perpendicular(vec3 a) {
    return normalize(abs(a.x) < 0.6 ? cross(a, vec3(1.0, 0.0, 0.0)) : cross(a, vec3(0.0, 1.0, 0.0)));
}

mat3 gramSchmidt(mat3 G) {
    float smallest = 1.0e-10 * (dot(G[0], G[0]) + dot(G[1], G[1]) + dot(G[2], G[2])) + 1.0e-30;
    float first = dot(G[0], G[0]);
    vec3 x = first > smallest ? G[0] * inversesqrt(first) : vec3(1.0, 0.0, 0.0);
    vec3 rest = G[1] - x * dot(x, G[1]);
    float second = dot(rest, rest);
    if (second <= smallest) return mat3(x, perpendicular(x), cross(x, perpendicular(x)));
    // Twice is enough: the first difference loses digits when the columns are nearly parallel.
    vec3 y = rest * inversesqrt(second);
    y = normalize(y - x * dot(x, y));
    return mat3(x, y, cross(x, y));
}

// Rotation by the vector w: exact rotation, angle 2·atan(|w|/2) = |w| + O(|w|³); no trigonometry.
mat3 smallRotation(vec3 w) {
    vec3 q = 0.5 * w;
    float s = 2.0 / (1.0 + dot(q, q));
    vec3 sq = s * q;
    vec3 d = sq * q;
    float xy = sq.x * q.y, yz = sq.y * q.z, zx = sq.z * q.x;
    return mat3(1.0 - d.y - d.z, xy + sq.z, zx - sq.y,  //
                xy - sq.z, 1.0 - d.z - d.x, yz + sq.x,  //
                zx + sq.y, yz - sq.x, 1.0 - d.x - d.y);
}

mat3 polarRotation(mat3 G) {
    mat3 R = gramSchmidt(G);
    // Two or three turns do for what a wall goes through; the bound is for elements crushed out of shape.
    for (int i = 0; i < 12; ++i) {
        mat3 A = transpose(R) * G;
        vec3 axial = vec3(A[1][2] - A[2][1], A[2][0] - A[0][2], A[0][1] - A[1][0]);
        float trace = A[0][0] + A[1][1] + A[2][2];
        // M = tr(S)·I − S, symmetric.
        vec3 diagonal = vec3(trace) - vec3(A[0][0], A[1][1], A[2][2]);
        vec3 off = -0.5 * vec3(A[1][2] + A[2][1], A[2][0] + A[0][2], A[0][1] + A[1][0]);  // yz, zx, xy
        vec3 cofactor = diagonal.yzx * diagonal.zxy - off * off;
        vec3 cofactorOff = off.yzx * off.zxy - diagonal * off;
        float determinant = diagonal.x * cofactor.x + off.z * cofactorOff.z + off.y * cofactorOff.y;
        vec3 w;
        if (diagonal.x > 0.0 && cofactor.z > 0.0 && determinant > 0.02 * trace * trace * trace) {
            mat3 inverseM = mat3(cofactor.x, cofactorOff.z, cofactorOff.y,  //
                                 cofactorOff.z, cofactor.y, cofactorOff.x,  //
                                 cofactorOff.y, cofactorOff.x, cofactor.z);
            w = inverseM * axial / determinant;
        } else {
            w = axial / (abs(trace) + 1.0e-9);
        }
        R = R * smallRotation(w);
        if (dot(w, w) < 1.0e-14) break;
    }
    return R;
}
