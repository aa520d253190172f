#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "core/world.hpp"

namespace sunder::core {

/// What `sunder run --json` says about a state. Energies and momenta include objects'.
struct Diagnostics {
    double kinetic = 0, elastic = 0, gravity = 0;  ///< J; gravity is −Σ m g·x
    Vec3 momentum{0, 0, 0};                        ///< kg·m/s
    Vec3 angularMomentum{0, 0, 0};                 ///< kg·m²/s, about the world's origin
    double minY = 0;                               ///< m
    double maxSpeed = 0;                           ///< m/s
    std::int64_t nan = 0;  ///< nodes and objects with a component that is not finite
    int bondsBroken = 0;
    int pieces = 0;
};

Diagnostics diagnose(const World&, const State&);

/// Deformation gradients (or their rates, from velocities) of a cell's five tetrahedra: derivatives
/// of places in the world by places at rest along the body's own axes, which are columns of F where
/// nothing is deformed. `field`: displacement or velocity, per node; `identity`: 1 for
/// displacements, 0 for rates.
std::array<Mat3, kTetrahedraPerCell> cellGradients(const World&, int cell,
                                                   const std::vector<Vec3>& field, double identity);

/// Largest principal Cauchy stress over a cell's tetrahedra, Pa, without damping.
double cellPrincipalStress(const World&, const State&, int cell);

/// 64-bit FNV-1a over every node's displacement and velocity in single precision, little-endian, in
/// node order, then over the objects.
std::uint64_t stateHash(const State&);

}  // namespace sunder::core
