// Eigenvalues (largest first) and eigenvectors (columns) of a symmetric 3×3 matrix by cyclic Jacobi rotations (Golub & Van Loan,
// Matrix Computations, §8.5). The thesis transcribes a Householder–QL routine (appendix A.1) with its loops unrolled away;
// Jacobi needs no such surgery and stays accurate where eigenvalues coincide.
//
// Written on scalars and vectors: with matrices indexed by a parameter, NVIDIA's driver 580 returned wrong eigenvectors.

// Turns the plane of axes p and q so that a_pq vanishes; r is the third axis, v the columns of eigenvectors so far.
void jacobiRotate(inout float app, inout float aqq, inout float apq, inout float apr, inout float aqr, inout vec3 vp,
                  inout vec3 vq) {
    if (apq == 0.0) return;
    float theta = (aqq - app) / (2.0 * apq);
    // Beyond this θ² would overflow, and t is 1/(2θ) to the last digit.
    float t = abs(theta) > 1.0e10 ? 0.5 / theta
                                  : (theta < 0.0 ? -1.0 : 1.0) / (abs(theta) + sqrt(theta * theta + 1.0));
    float c = inversesqrt(t * t + 1.0), s = t * c;
    app -= t * apq;
    aqq += t * apq;
    apq = 0.0;
    float pr = apr, qr = aqr;
    apr = c * pr - s * qr;
    aqr = s * pr + c * qr;
    vec3 p = vp, q = vq;
    vp = c * p - s * q;
    vq = s * p + c * q;
}

void orderEigen(inout float a, inout float b, inout vec3 va, inout vec3 vb) {
    if (a >= b) return;
    float value = a;
    a = b;
    b = value;
    vec3 vector = va;
    va = vb;
    vb = vector;
}

void symmetricEigen(mat3 a, out vec3 values, out mat3 vectors) {
    float xx = a[0][0], yy = a[1][1], zz = a[2][2], xy = a[0][1], yz = a[1][2], zx = a[2][0];
    vec3 x = vec3(1.0, 0.0, 0.0), y = vec3(0.0, 1.0, 0.0), z = vec3(0.0, 0.0, 1.0);
    for (int sweep = 0; sweep < 5; ++sweep) {
        jacobiRotate(xx, yy, xy, zx, yz, x, y);
        jacobiRotate(xx, zz, zx, xy, yz, x, z);
        jacobiRotate(yy, zz, yz, xy, zx, y, z);
    }
    orderEigen(xx, yy, x, y);
    orderEigen(yy, zz, y, z);
    orderEigen(xx, yy, x, y);
    values = vec3(xx, yy, zz);
    vectors = mat3(x, y, z);
}
