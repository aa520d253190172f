#pragma once
#include <string>
#include <vector>

#include "core/solver.hpp"

namespace sunder::core {

/// A sentence for each kind of thing that a solver of this world has had to leave out so far, and
/// what would keep it; never silent.
std::vector<std::string> lossNotes(const World&, const Solver&);

}  // namespace sunder::core
