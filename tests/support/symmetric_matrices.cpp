#include "support/symmetric_matrices.hpp"

#include <Eigen/Eigenvalues>

#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

std::vector<Mat3> symmetricMatrices(int count) {
    std::vector<Mat3> result;
    Random random(11);
    while (static_cast<int>(result.size()) < count) {
        const Mat3 R = random.rotation();
        Vec3 d = random.vector();
        switch (result.size() % 10) {
            case 0:
                d = {d[0], d[0], d[1]};
                break;
            case 1:
                d = {d[0], d[0] * (1 + 1e-6), d[1]};
                break;
            case 2:
                d = {d[0], 0, 0};
                break;
            case 3:
                d = {d[0], d[1], 0};
                break;
            case 4:
                d = {d[0], d[0] * (1 + 1e-3), d[0] * (1 - 1e-3)};
                break;
            default:
                break;
        }
        Mat3 A = R * d.asDiagonal() * R.transpose();
        if (result.size() % 10 == 5) A = d.asDiagonal();
        if (result.size() % 1000 == 6) A = d[0] * Mat3::Identity();
        if (result.size() % 1000 == 16) A.setZero();
        A *= std::pow(10.0, -6 + static_cast<double>(result.size() % 16));
        result.push_back((0.5 * (A + A.transpose())).cast<float>().cast<double>());
    }
    return result;
}

EigenErrors eigenErrors(const Mat3& A, const Vec3& values, const Mat3& vectors) {
    const Eigen::SelfAdjointEigenSolver<Mat3> truth(A);
    const double size = std::max(A.norm(), 1e-30);
    EigenErrors errors{0, 0,
                       (vectors.transpose() * vectors - Mat3::Identity()).cwiseAbs().maxCoeff(), 0};
    for (int i = 0; i < 3; ++i) {
        const Vec3 v = vectors.col(i);
        errors.value =
            std::max(errors.value, std::abs(values[i] - truth.eigenvalues()[2 - i]) / size);
        errors.residual = std::max(errors.residual, (A * v - values[i] * v).norm() / size);
        double gap = 1e300;
        for (int j = 0; j < 3; ++j)
            if (j != i)
                gap = std::min(gap,
                               std::abs(truth.eigenvalues()[2 - i] - truth.eigenvalues()[2 - j]));
        const Vec3 u = truth.eigenvectors().col(2 - i);
        if (gap > 0.01 * size) errors.vector = std::max(errors.vector, (v - u * u.dot(v)).norm());
    }
    return errors;
}
