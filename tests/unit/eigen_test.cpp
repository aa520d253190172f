#include "catch.hpp"
#include "core/symmetric_eigen.hpp"
#include "support/symmetric_matrices.hpp"

using namespace sunder;
using namespace sunder::core;

TEMPLATE_TEST_CASE("eigenvalues and eigenvectors match Eigen's", "", float, double) {
    EigenErrors worst{0, 0, 0, 0};
    for (const Mat3& A : symmetricMatrices(100000)) {
        const auto result = symmetricEigen<TestType>(A.cast<TestType>());
        const EigenErrors e = eigenErrors(A, result.values.template cast<double>(),
                                          result.vectors.template cast<double>());
        worst = {std::max(worst.value, e.value), std::max(worst.residual, e.residual),
                 std::max(worst.orthogonal, e.orthogonal), std::max(worst.vector, e.vector)};
        REQUIRE(result.values[0] >= result.values[1]);
        REQUIRE(result.values[1] >= result.values[2]);
    }
    // Some fifteen rotations, each rounding once or twice; a vector's error is that over its gap of
    // at least 1 %.
    const double epsilon = std::numeric_limits<TestType>::epsilon();
    CHECK(worst.value < 20 * epsilon);
    CHECK(worst.residual < 20 * epsilon);
    CHECK(worst.orthogonal < 20 * epsilon);
    CHECK(worst.vector < 20 * epsilon / 0.01);
}
