#pragma once
#include <cstdint>
#include <span>

#include "cpu/cpu_body.hpp"

// Kernels over a stretch of a body's vectors, from `first` to `end` (in units of kLanes cells).
// Each is compiled for every instruction set and picks the best one this machine has. All give the
// same bits whatever the width of a vector: every cell goes through the same operations alone, and
// no product is fused with a sum.
namespace sunder::cpu {

/// Forces of every cell on its own nodes; with `stress`, also what fracture needs.
void updateElements(const BodyArrays&, int first, int end, bool stress);

/// Symplectic Euler on joined groups, then the barriers. Returns the largest squared speed, m²/s².
float updateNodes(const BodyArrays&, int first, int end, std::span<const Push>);

struct BondNews {
    bool broke = false;    ///< a bond broke: see BodyArrays::broke
    bool damaged = false;  ///< the damage of a bond grew
};
/// `fracture = "cell"` and `"bond"`; `interval`: s since the last time.
BondNews updateBonds(const BodyArrays&, int first, int end, float interval);

/// Names of the instruction sets that this program holds and this machine can run, best first.
std::span<const std::int64_t> simdTargets();
const char* simdTargetName(std::int64_t target);
/// For tests: use only this instruction set from now on; 0: the best again.
void useSimdTarget(std::int64_t target);

}  // namespace sunder::cpu
