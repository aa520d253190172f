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

/// How a piece moves as a whole.
struct PieceMotion {
    int body = -1;
    int cells = 0;
    double mass = 0;                   ///< kg
    Vec3 centre{0, 0, 0};              ///< m, of its mass
    Vec3 velocity{0, 0, 0};            ///< m/s, of its centre
    Vec3 low{0, 0, 0}, high{0, 0, 0};  ///< m, around its nodes
    bool anchored = false;             ///< some of it never moves
};

/// By their numbers.
std::vector<PieceMotion> pieceMotions(const World&, const State&, const Pieces&);

/// How many bonds have broken.
int brokenBonds(const World&, const State&);

}  // namespace sunder::core
