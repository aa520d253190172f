// The functions under glsl/physics, one by one, against Eigen and the C++ side.
#include <bit>

#include "catch.hpp"
#include "core/elasticity.hpp"
#include "core/links.hpp"
#include "gpu/vertex_function.hpp"
#include "support/symmetric_matrices.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

void append(std::vector<float>& items, const Mat3& m) {
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) items.push_back(static_cast<float>(m(row, column)));
        items.push_back(0);
    }
}

Mat3 matrixAt(const float* columns) {
    Mat3 m;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) m(row, column) = columns[3 * column + row];
    return m;
}

constexpr const char* kItemMatrix = "mat3 A = mat3(item(0).xyz, item(1).xyz, item(2).xyz);";

}  // namespace

TEST_CASE("GLSL eigenvalues and eigenvectors match Eigen's") {
    const std::vector<Mat3> matrices = symmetricMatrices(100000);
    std::vector<float> items;
    for (const Mat3& A : matrices) append(items, A);
    const VertexFunction function{
        .includes = "physics/eigen.glsl",
        .outputs = "out vec3 values; out vec3 v0; out vec3 v1; out vec3 v2;",
        .names = {"values", "v0", "v1", "v2"},
        .body = std::string(kItemMatrix) +
                "vec3 d; mat3 v; symmetricEigen(A, d, v);"
                "values = d; v0 = v[0]; v1 = v[1]; v2 = v[2];",
        .itemTexels = 3,
        .resultFloats = 12};
    const std::vector<float> result = function.run(items, static_cast<int>(matrices.size()));
    EigenErrors worst{0, 0, 0, 0};
    for (std::size_t i = 0; i < matrices.size(); ++i) {
        const float* r = &result[12 * i];
        const EigenErrors e = eigenErrors(matrices[i], {r[0], r[1], r[2]}, matrixAt(r + 3));
        worst = {std::max(worst.value, e.value), std::max(worst.residual, e.residual),
                 std::max(worst.orthogonal, e.orthogonal), std::max(worst.vector, e.vector)};
    }
    // As for C++ in single precision; GL allows division and inversesqrt 2.5 ulp instead of ½.
    CHECK(worst.value < 60 * 1.2e-7);
    CHECK(worst.residual < 60 * 1.2e-7);
    CHECK(worst.orthogonal < 60 * 1.2e-7);
    CHECK(worst.vector < 60 * 1.2e-7 / 0.01);
}

TEST_CASE("the link mask of all 4,096 bond states matches a flood fill") {
    const VertexFunction function{.includes = "physics/links.glsl",
                                  .outputs = "flat out uvec4 low; flat out uvec4 high;",
                                  .names = {"low", "high"},
                                  .body = R"(uvec3 held = uvec3(0u);
                   for (int bond = 0; bond < 12; ++bond) {
                       if ((gl_VertexID >> bond & 1) == 0) continue;
                       int axis = bond / 4, n = bond % 4, below = (1 << axis) - 1;
                       held[axis] |= 1u << uint((n & below) | ((n & ~below) << 1));
                   }
                   for (int o = 0; o < 4; ++o) low[o] = linkMask(held, o);
                   for (int o = 0; o < 4; ++o) high[o] = linkMask(held, o + 4);)",
                                  .resultFloats = 8};
    const std::vector<float> input(4 * 4096, 0.0f);
    const std::vector<float> result = function.run(input, 4096);
    for (unsigned state = 0; state < 4096; ++state)
        for (int octant = 0; octant < 8; ++octant)
            REQUIRE(std::bit_cast<std::uint32_t>(result[8 * state + octant]) ==
                    linkMask(state, octant));
}

TEST_CASE("GLSL polar rotations match the SVD's") {
    std::vector<Mat3> matrices;
    std::vector<float> items;
    Random random(5);
    const auto add = [&](const Mat3& G) {
        matrices.push_back(G.cast<float>().cast<double>());
        append(items, G);
    };
    for (int i = 0; i < 20000; ++i) {
        // Strains up to 30 %, any rotation; then stretches of 0.3 to 3.
        add(random.rotation() * (Mat3::Identity() + 0.3 * 0.5 * random.matrix()));
        const Mat3 R = random.rotation();
        const Vec3 stretch = (random.vector() * std::log(3.0)).array().exp();
        add(random.rotation() * R * stretch.asDiagonal() * R.transpose());
    }
    const std::size_t regular = matrices.size();
    // Flat, needle-shaped, inverted and vanished elements: any rotation will do, but it must be
    // one.
    for (int i = 0; i < 2000; ++i) {
        const Mat3 A = random.rotation(), B = random.rotation();
        add(A * Vec3(1, 1, 0).asDiagonal() * B);
        add(A * Vec3(1, 0, 0).asDiagonal() * B);
        add(A * Vec3(1.1, 0.9, -0.7).asDiagonal() * B);
        add(A * Vec3(-1, -1, -1).asDiagonal() * B);
        add(Mat3::Zero());
    }
    const VertexFunction function{
        .includes = "physics/polar.glsl",
        .outputs = "out vec3 r0; out vec3 r1; out vec3 r2;",
        .names = {"r0", "r1", "r2"},
        .body = std::string(kItemMatrix) +
                "mat3 R = polarRotation(A); r0 = R[0]; r1 = R[1]; r2 = R[2];",
        .itemTexels = 3,
        .resultFloats = 9};
    const std::vector<float> result = function.run(items, static_cast<int>(matrices.size()));
    double rotation = 0, error = 0;
    for (std::size_t i = 0; i < matrices.size(); ++i) {
        const Mat3 R = matrixAt(&result[9 * i]);
        rotation = std::max(rotation, (R.transpose() * R - Mat3::Identity()).cwiseAbs().maxCoeff());
        if (i < regular)
            error = std::max(error, (R - polarRotation(matrices[i])).cwiseAbs().maxCoeff());
    }
    CHECK(rotation < 2e-6);  // a product of five rotations in single precision
    CHECK(error <
          1e-5);  // Newton's last step: rounding over the smallest sum of two stretches, 0.6
}
