#pragma once
#include <string_view>
#include <vector>

#include "sim/solvers.hpp"

namespace sunder::sim_gl {

/// All solvers: those of the GPU, the default first, and those of the CPU.
const std::vector<sim::SolverInfo>& solvers();
/// Throws InputError listing the known ones, on behalf of a command line's `option`.
const sim::SolverInfo& findSolver(std::string_view name, std::string_view option = "--solver");

}  // namespace sunder::sim_gl
