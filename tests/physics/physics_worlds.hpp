#pragma once
#include <string>
#include <vector>

#include "core/world.hpp"
#include "support/solver_under_test.hpp"

/// One body of cubic cells with edges of `cell` m, of E Pa, ν and 1000 kg/m³, unbreakable; no drag,
/// gravity, ground, contact, or anchors.
sunder::core::WorldDescription elasticBlock(sunder::core::IVec3 cells, double cell,
                                            double youngModulus, double poissonRatio);

/// A force of 0 N for all time: nobody feels it, and no body falls asleep.
void keepAwake(sunder::core::WorldDescription&);

/// No element's stiffness was limited to what the step carries.
void requireUnlimited(const sunder::core::World&);

/// reference, cpu, gather and scatter. `auto` is made of cpu and gather, to the bit.
std::vector<SolverUnderTest> allSolvers();

/// m, of a node at rest, not rounded to single precision as World::restPosition() is.
sunder::core::Vec3 latticePosition(const sunder::core::World&, int node);
