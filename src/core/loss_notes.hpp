#pragma once
#include <string>
#include <vector>

#include "core/solver.hpp"

namespace sunder {

/// A sentence for each kind of thing that the solver has had to leave out so far; never silent.
std::vector<std::string> lossNotes(const Solver&);

}  // namespace sunder
