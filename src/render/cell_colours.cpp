#include "render/cell_colours.hpp"

#include <algorithm>
#include <cmath>

#include "core/diagnostics.hpp"
#include "core/pieces.hpp"
#include "render/colour_map.hpp"

namespace sunder {
namespace {

// Where the scales begin: a wall at rest, or falling asleep, is dark and not noise in full colour.
constexpr double kLeastStress = 1e4;  // Pa
constexpr double kLeastSpeed = 1;     // m/s

/// The next of 1, 2 and 5 times powers of ten.
double roundedUp(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double step : {1, 2, 5})
        // Room for what rounding does to a value that is one of the steps.
        if (value <= step * power * (1 + 1e-9)) return step * power;
    return 10 * power;
}

/// m/s, of the centre of mass: a cell's nodes weigh the same.
double cellSpeed(const State& state, int cell) {
    Vec3 sum = Vec3::Zero();
    for (int node = kCorners * cell; node < kCorners * (cell + 1); ++node)
        sum += state.velocity[node];
    return sum.norm() / kCorners;
}

}  // namespace

std::string_view toString(WallColour colour) {
    switch (colour) {
        case WallColour::Stress:
            return "stress";
        case WallColour::Speed:
            return "speed";
        case WallColour::Piece:
            return "piece";
        case WallColour::Material:
            break;
    }
    return "material";
}

CellColours::CellColours(const World& world)
    : world_(world), stressEnd_(kLeastStress), speedEnd_(kLeastSpeed) {}

void CellColours::update(const State& state, WallColour colour) {
    key_ = {};
    key_.colour = colour;
    colours_.assign(colour == WallColour::Material ? 0 : world_.cellCount(), glm::vec4(0));
    switch (colour) {
        case WallColour::Material:
            break;
        case WallColour::Stress:
            colourByScale(stressEnd_,
                          [&](int cell) { return cellPrincipalStress(world_, state, cell); });
            break;
        case WallColour::Speed:
            colourByScale(speedEnd_, [&](int cell) { return cellSpeed(state, cell); });
            break;
        case WallColour::Piece:
            colourByPiece(state);
            break;
    }
}

template <typename Value>
void CellColours::colourByScale(double& end, Value valueOf) {
    std::vector<double> values(world_.cellCount());
    for (int cell = 0; cell < world_.cellCount(); ++cell) {
        if (!world_.present(cell)) continue;
        values[cell] = valueOf(cell);
        if (values[cell] > end && std::isfinite(values[cell])) end = roundedUp(values[cell]);
    }
    for (int cell = 0; cell < world_.cellCount(); ++cell)
        if (world_.present(cell)) colours_[cell] = glm::vec4(mapColour(values[cell] / end), 1);
    key_.end = end;
}

void CellColours::colourByPiece(const State& state) {
    const Pieces pieces = findPieces(world_, state);
    std::vector<int> firstCell(pieces.count, -1), size(pieces.count, 0);
    for (int cell = 0; cell < world_.cellCount(); ++cell) {
        const int piece = pieces.ofCell[cell];
        if (piece >= 0 && size[piece]++ == 0) firstCell[piece] = cell;
    }
    // What is left of each body is neutral, as in a paper's figures; what came off it is not.
    std::vector<int> largest(world_.bodies().size(), -1);
    for (int piece = 0; piece < pieces.count; ++piece) {
        int& most = largest[world_.bodyOf(firstCell[piece])];
        if (most < 0 || size[piece] > size[most]) most = piece;
    }
    for (int cell = 0; cell < world_.cellCount(); ++cell) {
        const int piece = pieces.ofCell[cell];
        if (piece < 0) continue;
        const bool neutral = largest[world_.bodyOf(cell)] == piece;
        colours_[cell] = glm::vec4(neutral ? kNeutralColour : distinctColour(firstCell[piece]), 1);
    }
    key_.pieces = pieces.count;
}

}  // namespace sunder
