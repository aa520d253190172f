#include "core/diagnostics.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/elasticity.hpp"
#include "core/pieces.hpp"
#include "core/tetrahedra.hpp"

namespace sunder::core {
namespace {

constexpr double kVolumeShare[kTetrahedraPerCell] = {1. / 6, 1. / 6, 1. / 6, 1. / 6, 1. / 3};

}  // namespace

std::array<Mat3, kTetrahedraPerCell> cellGradients(const World& world, int cell,
                                                   const std::vector<Vec3>& field,
                                                   double identity) {
    std::array<Mat3, kTetrahedraPerCell> result;
    const Mat3& axes = world.bodies()[world.bodyOf(cell)].axes;
    for (int t = 0; t < kTetrahedraPerCell; ++t) {
        const Tetrahedron& tet = kTetrahedra[world.parity(cell)][t];
        Mat3 rest, change;
        for (int edge = 0; edge < 3; ++edge) {
            rest.col(edge) =
                world.cornerOffset(cell, tet[edge + 1]) - world.cornerOffset(cell, tet[0]);
            change.col(edge) =
                field[kCorners * cell + tet[edge + 1]] - field[kCorners * cell + tet[0]];
        }
        result[t] = identity * axes + change * rest.inverse();
    }
    return result;
}

double cellPrincipalStress(const World& world, const State& state, int cell) {
    const ElementLaw& law = world.laws()[world.lawOf(cell)];
    const auto gradients = cellGradients(world, cell, state.displacement, 1);
    double largest = -std::numeric_limits<double>::infinity();
    for (const Mat3& F : gradients) {
        const ElementStress stress =
            elementStress(law, world.materialOf(cell).law, F, Mat3::Zero(), world.step());
        largest = std::max(largest, largestPrincipalStress(law, F, stress.piola));
    }
    return largest;
}

Diagnostics diagnose(const World& world, const State& state) {
    Diagnostics d;
    d.minY = std::numeric_limits<double>::infinity();
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        if (!world.present(cell, state)) continue;
        const Body& body = world.bodies()[world.bodyOf(cell)];
        bool finite = true;
        for (int node = kCorners * cell; node < kCorners * (cell + 1); ++node) {
            const Vec3 x = world.restPosition(node) + state.displacement[node];
            const Vec3& v = state.velocity[node];
            if (!x.allFinite() || !v.allFinite()) {
                ++d.nan;
                finite = false;
                continue;
            }
            const double m = world.nodeMass(node);
            d.kinetic += 0.5 * m * v.squaredNorm();
            d.gravity -= m * body.gravity.dot(x);
            d.momentum += m * v;
            d.angularMomentum += m * x.cross(v);
            d.minY = std::min(d.minY, x[1]);
            d.maxSpeed = std::max(d.maxSpeed, v.norm());
        }
        if (finite) {
            const auto gradients = cellGradients(world, cell, state.displacement, 1);
            const ElementLaw& law = world.laws()[world.lawOf(cell)];
            for (int t = 0; t < kTetrahedraPerCell; ++t)
                d.elastic += kVolumeShare[t] * law.cellSize.prod() *
                             energyDensity(law, world.materialOf(cell).law, gradients[t]);
        }
    }
    for (std::size_t i = 0; i < state.objects.size(); ++i) {
        const ObjectState& object = state.objects[i];
        const double inverseMass = world.objects()[i].inverseMass;
        if (!object.present || inverseMass == 0) continue;
        if (!object.position.allFinite() || !object.velocity.allFinite() ||
            !object.orientation.coeffs().allFinite() || !object.angularMomentum.allFinite()) {
            ++d.nan;
            continue;
        }
        const Vec3 momentum = object.velocity / inverseMass;
        d.kinetic += object.kineticEnergy(world.objects()[i]);
        d.gravity -= world.description().gravity.dot(object.position) / inverseMass;
        d.momentum += momentum;
        d.angularMomentum += object.position.cross(momentum) + object.angularMomentum;
    }
    d.bondsBroken = brokenBonds(world, state);
    d.pieces = findPieces(world, state).count;
    return d;
}

std::uint64_t stateHash(const State& state) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](const Vec3& v) {
        for (int i = 0; i < 3; ++i) {
            const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(v[i]));
            for (int byte = 0; byte < 4; ++byte)
                hash = (hash ^ (bits >> 8 * byte & 0xff)) * 0x100000001b3u;
        }
    };
    for (std::size_t node = 0; node < state.displacement.size(); ++node) {
        add(state.displacement[node]);
        add(state.velocity[node]);
    }
    for (const ObjectState& object : state.objects) {
        add(object.position);
        add(object.orientation.vec());
        add(object.velocity);
        add(object.angularMomentum);
    }
    for (const int body : state.absent) add(Vec3::Constant(body));
    for (const int body : state.released) add(Vec3::Constant(-1 - body));
    return hash;
}

}  // namespace sunder::core
