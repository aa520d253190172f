#pragma once
#include <vector>

#include "core/world.hpp"

namespace sunder::core {

struct Pieces {
    std::vector<int>
        ofCell;  ///< piece number of each cell, 0-based in order of first cell; −1 for absent cells
    int count = 0;
};

/// Connected groups of cells: two cells belong together when a chain of unbroken bonds joins them.
Pieces findPieces(const World&, const State&);

}  // namespace sunder::core
