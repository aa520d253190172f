// Eigenvalues (largest first) and eigenvectors (columns) of a symmetric 3×3 matrix by cyclic Jacobi rotations (Golub & Van Loan,
// Matrix Computations, §8.5). The thesis transcribes a Householder–QL routine (appendix A.1) with its loops unrolled away;
// Jacobi needs no such surgery and stays accurate where eigenvalues coincide.

void jacobiRotate(inout mat3 a, inout mat3 v, int p, int q) {
    float apq = a[p][q];
    if (apq == 0.0) return;
    int r = 3 - p - q;
    float theta = (a[q][q] - a[p][p]) / (2.0 * apq);
    // Beyond this θ² would overflow, and t is 1/(2θ) to the last digit.
    float t = abs(theta) > 1.0e10 ? 0.5 / theta
                                  : (theta < 0.0 ? -1.0 : 1.0) / (abs(theta) + sqrt(theta * theta + 1.0));
    float c = inversesqrt(t * t + 1.0), s = t * c;
    float apr = a[p][r], aqr = a[q][r];
    a[p][p] -= t * apq;
    a[q][q] += t * apq;
    a[p][q] = 0.0;
    a[q][p] = 0.0;
    a[p][r] = c * apr - s * aqr;
    a[r][p] = a[p][r];
    a[q][r] = s * apr + c * aqr;
    a[r][q] = a[q][r];
    vec3 vp = v[p], vq = v[q];
    v[p] = c * vp - s * vq;
    v[q] = s * vp + c * vq;
}

void orderEigen(inout vec3 values, inout mat3 vectors, int i, int j) {
    if (values[i] >= values[j]) return;
    float value = values[i];
    values[i] = values[j];
    values[j] = value;
    vec3 column = vectors[i];
    vectors[i] = vectors[j];
    vectors[j] = column;
}

void symmetricEigen(mat3 a, out vec3 values, out mat3 vectors) {
    vectors = mat3(1.0);
    for (int sweep = 0; sweep < 5; ++sweep) {
        jacobiRotate(a, vectors, 0, 1);
        jacobiRotate(a, vectors, 0, 2);
        jacobiRotate(a, vectors, 1, 2);
    }
    values = vec3(a[0][0], a[1][1], a[2][2]);
    orderEigen(values, vectors, 0, 1);
    orderEigen(values, vectors, 1, 2);
    orderEigen(values, vectors, 0, 1);
}
