#include "core/pieces.hpp"

#include <numeric>

namespace sunder::core {

Pieces findPieces(const World& world, const State& state) {
    // Union–find with path halving.
    std::vector<int> parent(world.cellCount());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int cell) {
        while (parent[cell] != cell) cell = parent[cell] = parent[parent[cell]];
        return cell;
    };
    for (int cell = 0; cell < world.cellCount(); ++cell)
        for (int axis = 0; axis < 3; ++axis) {
            if (state.damage[kBondsPerCell * cell + axis] >= 1) continue;
            const int a = root(cell), b = root(world.neighbour(cell, axis, +1));
            parent[std::max(a, b)] = std::min(a, b);
        }
    Pieces pieces;
    pieces.ofCell.assign(world.cellCount(), -1);
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        if (!world.present(cell)) continue;
        const int first = root(cell);  // never after `cell`: the smaller index is always the root
        pieces.ofCell[cell] = first == cell ? pieces.count++ : pieces.ofCell[first];
    }
    return pieces;
}

}  // namespace sunder::core
