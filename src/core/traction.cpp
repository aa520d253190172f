#include "core/traction.hpp"

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "core/diagnostics.hpp"
#include "core/elasticity.hpp"
#include "core/tetrahedra.hpp"

namespace sunder::core {
namespace {

CornerStresses stressesAtRest(const World& world, int cell, const std::vector<Vec3>& displacement) {
    CornerStresses stresses;
    const auto gradients = cellGradients(world, cell, displacement, 1);
    for (int t = 0; t < 4; ++t) {
        const auto [piola, rotation] =
            elementStress(world.laws()[world.lawOf(cell)], world.materialOf(cell).law, gradients[t],
                          Mat3::Zero(), world.step());
        const Mat3 biot = rotation.transpose() * piola;
        stresses[kTetrahedra[world.parity(cell)][t][0] / 2] = 0.5 * (biot + biot.transpose());
    }
    return stresses;
}

}  // namespace

double equivalentTraction(const World& world, int cell, int axis, const CornerStresses& own,
                          const CornerStresses& neighbours) {
    const Material& material = world.materialOf(cell);
    double normal[2], shear[2];
    int triangle = 0;
    for (int t = 0; t < 4; ++t) {
        // The face's two triangles belong to the corner tetrahedra whose apex lies on it, on either
        // side.
        const int apex = kTetrahedra[world.parity(cell)][t][0];
        if (!(apex >> axis & 1)) continue;
        const Mat3 T = 0.5 * (own[apex / 2] + neighbours[(apex ^ 1 << axis) / 2]);
        normal[triangle] = T(axis, axis);
        shear[triangle] = std::hypot(T(axis, (axis + 1) % 3), T(axis, (axis + 2) % 3));
        ++triangle;
    }
    const double tn = 0.5 * (normal[0] + normal[1]) + std::abs(normal[0] - normal[1]);
    const double ts =
        std::max(0.0, 0.5 * (shear[0] + shear[1]) - material.internalFriction * std::max(-tn, 0.0));
    const double tension = std::max(tn, 0.0);
    return std::sqrt(tension * tension + material.shearWeight * ts * ts);
}

double slowShare(const World& world) {
    return std::min(1.0, world.fractureInterval() * world.step() / kSlowTime);
}

void makeStressesSlow(const World& world, int index, State& state) {
    const Body& body = world.bodies()[index];
    const int end = body.firstCell + body.cellCount();
    std::vector<CornerStresses> stresses;
    const auto stressesOf = [&](int cell) -> const CornerStresses& {
        if (stresses.empty()) {
            stresses.resize(static_cast<std::size_t>(body.cellCount()));
            for (int any = body.firstCell; any < end; ++any)
                if (world.present(any))
                    stresses[any - body.firstCell] = stressesAtRest(world, any, state.displacement);
        }
        return stresses[cell - body.firstCell];
    };
    for (int cell = body.firstCell; cell < end; ++cell) {
        if (!world.present(cell)) continue;
        const ElementLaw& law = world.laws()[world.lawOf(cell)];
        if (law.limited && std::isfinite(law.maxStress))
            state.slowStress[cell] =
                std::max(0.0, cellPrincipalStress(world, state, cell) / law.stressScale);
        for (int axis = 0; axis < 3; ++axis) {
            const int bond = kBondsPerCell * cell + axis;
            if (std::isfinite(world.bondStrength(bond)))
                state.slow[bond] = equivalentTraction(world, cell, axis, stressesOf(cell),
                                                      stressesOf(world.neighbour(cell, axis, +1)));
        }
    }
}

}  // namespace sunder::core
