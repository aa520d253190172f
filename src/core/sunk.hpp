#pragma once
#include <string>
#include <vector>

#include "core/world.hpp"

namespace sunder::core {

/// Two things that are in each other though the scene did not put them there: more than their
/// contact could carry.
struct Sunk {
    std::string a, b;    ///< bodies, then objects
    double depth = 0;    ///< m, where it is deepest
    double thinner = 0;  ///< m: of the thinner one's cells, or itself where it is an object
};

/// Pairs of which one is in the other by more than half of a cell (bodies, or objects in bodies) or
/// a third of its thickness (objects): far beyond what touch asks for. In the order of the world.
std::vector<Sunk> sunkThings(const World&, const State&);

/// A sentence about them, and what would carry more; empty where there are none.
std::string sunkNote(const std::vector<Sunk>&);

}  // namespace sunder::core
