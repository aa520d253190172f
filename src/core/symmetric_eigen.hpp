#pragma once
#include <Eigen/Core>
#include <cmath>
#include <utility>

namespace sunder::core {

/// Eigenvalues, largest first, and their eigenvectors (columns, orthonormal) of a symmetric 3×3
/// matrix.
template <class T>
struct SymmetricEigen {
    Eigen::Matrix<T, 3, 1> values;
    Eigen::Matrix<T, 3, 3> vectors;
};

/// Cyclic Jacobi rotations (Golub & Van Loan, Matrix Computations, §8.5). Chosen over closed forms
/// because it stays accurate to the last digits when eigenvalues coincide; four sweeps reach
/// single, six double precision.
template <class T>
SymmetricEigen<T> symmetricEigen(Eigen::Matrix<T, 3, 3> a) {
    Eigen::Matrix<T, 3, 3> v = Eigen::Matrix<T, 3, 3>::Identity();
    const int sweeps = sizeof(T) == 4 ? 5 : 7;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
            if (a(p, q) == T(0)) continue;
            // The smaller root of t² + 2θt − 1 = 0 keeps the rotation below 45°.
            const T theta = (a(q, q) - a(p, p)) / (T(2) * a(p, q));
            const T t = std::isinf(theta * theta)
                            ? T(0.5) / theta
                            : std::copysign(T(1), theta) /
                                  (std::abs(theta) + std::sqrt(theta * theta + T(1)));
            const T c = T(1) / std::sqrt(t * t + T(1)), s = t * c;
            const int r = 3 - p - q;
            const T apr = a(p, r), aqr = a(q, r), apq = a(p, q);
            a(p, p) -= t * apq;
            a(q, q) += t * apq;
            a(p, q) = a(q, p) = T(0);
            a(p, r) = a(r, p) = c * apr - s * aqr;
            a(q, r) = a(r, q) = s * apr + c * aqr;
            const Eigen::Matrix<T, 3, 1> vp = v.col(p), vq = v.col(q);
            v.col(p) = c * vp - s * vq;
            v.col(q) = s * vp + c * vq;
        }
    }
    SymmetricEigen<T> result{a.diagonal(), v};
    const auto order = [&](int i, int j) {
        if (result.values[i] >= result.values[j]) return;
        std::swap(result.values[i], result.values[j]);
        result.vectors.col(i).swap(result.vectors.col(j));
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    return result;
}

}  // namespace sunder::core
