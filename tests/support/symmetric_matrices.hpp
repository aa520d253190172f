#pragma once
#include <vector>

#include "core/types.hpp"

/// `count` symmetric matrices, rounded to single precision: random ones of all sizes from 1e-6 to
/// 1e9, diagonal ones, multiples of the identity, double and nearly double eigenvalues, rank one
/// and two, zero.
std::vector<sunder::core::Mat3> symmetricMatrices(int count);

/// How far values and vectors are from an eigen-decomposition of A by Eigen, all relative to |A|.
struct EigenErrors {
    double value;       ///< largest difference of a sorted eigenvalue from Eigen's
    double residual;    ///< largest |A·v − λ·v|
    double orthogonal;  ///< largest entry of |VᵀV − I|
    double vector;  ///< largest angle's sine to Eigen's eigenvector, over those with a gap of 1 %
                    ///< of |A| on both sides
};
EigenErrors eigenErrors(const sunder::core::Mat3& A, const sunder::core::Vec3& values,
                        const sunder::core::Mat3& vectors);
