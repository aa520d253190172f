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
        if (!world.present(cell, state)) continue;
        const int first = root(cell);  // never after `cell`: the smaller index is always the root
        pieces.ofCell[cell] = first == cell ? pieces.count++ : pieces.ofCell[first];
    }
    return pieces;
}

std::vector<PieceMotion> pieceMotions(const World& world, const State& state,
                                      const Pieces& pieces) {
    std::vector<PieceMotion> motions(pieces.count);
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        if (pieces.ofCell[cell] < 0) continue;
        PieceMotion& piece = motions[pieces.ofCell[cell]];
        piece.body = world.bodyOf(cell);
        for (int node = kCorners * cell; node < kCorners * (cell + 1); ++node) {
            const double mass = world.nodeMass(node);
            const Vec3 place = world.restPosition(node) + state.displacement[node];
            const bool first = piece.cells == 0 && node == kCorners * cell;
            piece.low = first ? place : piece.low.cwiseMin(place);
            piece.high = first ? place : piece.high.cwiseMax(place);
            piece.mass += mass;
            piece.centre += mass * place;
            piece.velocity += mass * state.velocity[node];
            piece.anchored |= world.anchored(node, state);
        }
        ++piece.cells;
    }
    for (PieceMotion& piece : motions) {
        piece.centre /= piece.mass;
        piece.velocity /= piece.mass;
    }
    return motions;
}

int brokenBonds(const World& world, const State& state) {
    int broken = 0;
    for (int bond = 0; bond < world.bondSlots(); ++bond)
        broken += state.damage[bond] >= 1 && state.damage[bond] != kNoBond;
    return broken;
}

}  // namespace sunder::core
