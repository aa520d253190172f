#include "core/elasticity.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "core/symmetric_eigen.hpp"

namespace sunder::core {

double cellFrequencyFactor(double nu) {
    constexpr struct {
        double nu, kappa;
    } table[] = {{0, 2.74},   {.2, 2.98}, {.25, 3.19}, {.3, 3.51},
                 {.35, 3.99}, {.4, 4.84}, {.45, 6.79}};
    // κ² is linear in 1/(1−2ν), the growth of λ, to three digits; also beyond the table.
    std::size_t i = 1;
    while (i + 1 < std::size(table) && nu > table[i].nu) ++i;
    const auto growth = [](double ratio) { return 1 / (1 - 2 * ratio); };
    const auto &a = table[i - 1], &b = table[i];
    const double share = (growth(nu) - growth(a.nu)) / (growth(b.nu) - growth(a.nu));
    return std::sqrt(a.kappa * a.kappa + (b.kappa * b.kappa - a.kappa * a.kappa) * share);
}

double stableYoungModulus(double density, double edge, double nu, double h) {
    const double waveSpeed = 0.9 * 2 * edge / (cellFrequencyFactor(nu) * h);
    return density * waveSpeed * waveSpeed / (1 + 2 * kDamping);
}

double hotViscosity(double mu, double reserve, double h) {
    const double wanted = 1.5 * std::sqrt(reserve) - kHotDamping;
    const double room = 0.5 * (reserve * (1 + 2 * kDamping) - (1 + 2 * kHotDamping));
    return 2 * mu * h * std::max(0.0, std::min(wanted, room));
}

double largestGreenStress(double density, double edge, double h) {
    return 0.2 * density * (edge / h) * (edge / h);
}

double hotDeterminant(double viscosity) {
    return viscosity > 0 ? 0.5 : 0.3;
}

Mat3 polarRotation(const Mat3& G) {
    // Far from singular, Higham's iteration R ← ½(R + R⁻ᵀ) doubles the digits each time (Higham
    // 1986).
    const double size = G.norm();
    if (G.determinant() > 1e-3 * size * size * size) {
        Mat3 R = G;
        for (int i = 0; i < 20; ++i) {
            const Mat3 next = 0.5 * (R + R.inverse().transpose());
            const double change = (next - R).norm();
            R = next;
            if (change < 1e-15) break;
        }
        return R;
    }
    const Eigen::JacobiSVD<Mat3> svd(G, Eigen::ComputeFullU | Eigen::ComputeFullV);
    // Singular values come sorted: a reflection is taken out of the smallest one, which maximises
    // tr(RᵀG).
    const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    return svd.matrixU() * Vec3(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

namespace {

/// Strongly deformed.
bool isHot(const ElementLaw& law, const Mat3& F) {
    return F.determinant() < hotDeterminant(law.hotViscosity) || F.squaredNorm() > 6;
}

/// Axes that follow the columns of F (Gram–Schmidt), which is far from singular.
Mat3 frameOf(const Mat3& F) {
    Mat3 frame;
    frame.col(0) = F.col(0).normalized();
    frame.col(1) = (F.col(1) - frame.col(0) * frame.col(0).dot(F.col(1))).normalized();
    frame.col(2) = frame.col(0).cross(frame.col(1));
    return frame;
}

}  // namespace

Mat3 turnedBack(const ElementLaw& law, const Mat3& F, const Mat3& rate, double h) {
    const Mat3 change = kDamping * h * rate;
    const bool asOne = change.squaredNorm() < kMostTurn2 && F.squaredNorm() < kMostStretch2;
    if (isHot(law, F) || !asOne) return Mat3::Identity();
    return frameOf(F) * frameOf(F + change).transpose();
}

ElementStress elementStress(const ElementLaw& law, ConstitutiveLaw kind, const Mat3& F,
                            const Mat3& rate, double h) {
    const bool hot = isHot(law, F);
    const Mat3 G = F + (hot ? kHotDamping : kDamping) * h * rate;
    const Mat3 R = polarRotation(G);
    Mat3 P;
    if (kind == ConstitutiveLaw::Corotated) {
        P = 2 * law.mu * (G - R) + law.lambda * ((R.transpose() * G).trace() - 3) * R;
    } else {
        const Mat3 strain = 0.5 * (G.transpose() * G - Mat3::Identity());
        P = G * (2 * law.mu * strain + law.lambda * strain.trace() * Mat3::Identity());
        if (const double size = P.norm(); size > law.largestStress) P *= law.largestStress / size;
    }
    if (hot && law.hotViscosity > 0)
        P += law.hotViscosity * rate;
    else if (hot)  // keeps the stability limit E·(1+2b) where b is larger
        P *= (1 + 2 * kDamping) / (1 + 2 * kHotDamping);
    return {P, R};
}

double energyDensity(const ElementLaw& law, ConstitutiveLaw kind, const Mat3& F) {
    Mat3 strain;
    if (kind == ConstitutiveLaw::Corotated)
        strain = polarRotation(F).transpose() * F - Mat3::Identity();
    else
        strain = 0.5 * (F.transpose() * F - Mat3::Identity());
    return law.mu * strain.squaredNorm() + 0.5 * law.lambda * strain.trace() * strain.trace();
}

double largestPrincipalStress(const ElementLaw& law, const Mat3& F, const Mat3& piola) {
    const Mat3 kirchhoff = piola * F.transpose();
    const Mat3 cauchy = 0.5 * (kirchhoff + kirchhoff.transpose()) / std::max(F.determinant(), 0.05);
    return symmetricEigen<double>(cauchy).values[0] * law.stressScale;
}

}  // namespace sunder::core
