// Rotation R of the polar decomposition G = R·S: the rotation that maximises tr(Rᵀ·G), also for inverted G.
//
// Starts from Gram–Schmidt, with A = RᵀG, and turns R by a Cayley rotation by w, which makes A symmetric exactly where
// M·w = k − ¼(k·w)·w, with M = tr(S)·I − S, S and k the symmetric part and the axial vector of A. So M is inverted once and w found by
// fixed-point iteration, each turn of which gains a factor of about ½|w|². Where M is not safely positive definite (flat or inverted
// elements) or w is large, R is turned again and again: by Newton's equation, or by the step of Müller et al. 2016, "A Robust Method to
// Extract the Rotational Part of Deformations". By itself that would leave 1/81 of the first error after four turns: a skew stress,
// which does not keep angular momentum.

vec3 perpendicular(vec3 a) {
    return normalize(abs(a.x) < 0.6 ? cross(a, vec3(1.0, 0.0, 0.0)) : cross(a, vec3(0.0, 1.0, 0.0)));
}

mat3 gramSchmidt(mat3 G) {
    float first = dot(G[0], G[0]);
    float whole = first + dot(G[1], G[1]) + dot(G[2], G[2]);
    float smallest = 1.0e-10 * whole + 1.0e-30;
    vec3 x = first > smallest ? G[0] * inversesqrt(first) : vec3(1.0, 0.0, 0.0);
    vec3 rest = G[1] - x * dot(x, G[1]);
    float second = dot(rest, rest);
    if (second <= smallest) return mat3(x, perpendicular(x), cross(x, perpendicular(x)));
    vec3 y = rest * inversesqrt(second);
    // The difference loses digits when the columns are nearly parallel: then once more.
    if (second < 0.1 * whole) y = normalize(y - x * dot(x, y));
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

// What turns R: k, M⁻¹ and whether M is well positive definite.
struct Turn {
    vec3 axial;
    float trace;
    mat3 inverse_;  // of M, where that is so
    bool safe;
};

Turn turnOf(mat3 A) {
    vec3 axial = vec3(A[1][2] - A[2][1], A[2][0] - A[0][2], A[0][1] - A[1][0]);
    vec3 own = vec3(A[0][0], A[1][1], A[2][2]);
    vec3 diagonal = own.yzx + own.zxy;
    vec3 off = -0.5 * vec3(A[1][2] + A[2][1], A[2][0] + A[0][2], A[0][1] + A[1][0]);  // yz, zx, xy
    vec3 cofactor = diagonal.yzx * diagonal.zxy - off * off;
    vec3 cofactorOff = off.yzx * off.zxy - diagonal * off;
    float determinant_ = diagonal.x * cofactor.x + off.z * cofactorOff.z + off.y * cofactorOff.y;
    float trace = own.x + own.y + own.z;
    bool safe = diagonal.x > 0.0 && cofactor.z > 0.0 && determinant_ > 0.02 * trace * trace * trace;
    float inverse_ = 1.0 / determinant_;
    vec3 d = inverse_ * cofactor, o = inverse_ * cofactorOff;
    return Turn(axial, trace, mat3(d.x, o.z, o.y, o.z, d.y, o.x, o.y, o.x, d.z), safe);
}

mat3 polarOfAny(mat3 G, mat3 R) {
    for (int i = 0; i < 12; ++i) {
        Turn turn = turnOf(transpose(R) * G);
        vec3 w = turn.safe ? turn.inverse_ * turn.axial : turn.axial / (abs(turn.trace) + 1.0e-9);
        R = R * smallRotation(w);
        if (dot(w, w) < 1.0e-14) break;
    }
    return R;
}

mat3 polarRotation(mat3 G) {
    mat3 R = gramSchmidt(G);
    Turn turn = turnOf(transpose(R) * G);
    vec3 first = turn.inverse_ * turn.axial;
    // Below 0.03 rad the second w is right to 1e-8 already.
    vec3 w = turn.inverse_ * (turn.axial - 0.25 * dot(turn.axial, first) * first);
    float size = dot(w, w);
    if (!turn.safe || size > 0.1) return polarOfAny(G, R);
    if (size > 1.0e-3)
        for (int i = 0; i < 6; ++i) w = turn.inverse_ * (turn.axial - 0.25 * dot(turn.axial, w) * w);
    return R * smallRotation(w);
}
