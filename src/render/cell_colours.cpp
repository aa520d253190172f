#include "render/cell_colours.hpp"

#include <algorithm>
#include <cmath>

#include "core/diagnostics.hpp"
#include "core/pieces.hpp"
#include "render/colour_map.hpp"

namespace sunder::render {

using namespace core;

namespace {

// Where the scales begin: a wall at rest, or falling asleep, is dark and not noise in full colour.
constexpr double kLeastStrain = 1e-4;  // times Young's modulus
constexpr double kLeastSpeed = 1;      // m/s

/// The next of 1, 2 and 5 times powers of ten.
double roundedUp(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double step : {1, 2, 5})
        // Room for what rounding does to a value that is one of the steps.
        if (value <= step * power * (1 + 1e-9)) return step * power;
    return 10 * power;
}

/// The scale's end so far, and further if a value is beyond it.
double grown(double end, const std::vector<double>& values) {
    for (const double value : values)
        if (value > end && std::isfinite(value)) end = roundedUp(value);
    return end;
}

/// Pa, the most that any of the world's materials bears in any direction; 0 where nothing breaks.
double highestStrength(const World& world) {
    double highest = 0;
    for (const ElementLaw& law : world.laws()) {
        const Material& material = world.description().materials[law.material];
        if (material.fracture == FractureMode::Bond)
            highest = std::max(highest, material.strength.maxCoeff());
        if (material.fracture == FractureMode::Cell)
            highest = std::max(highest, material.maxStress);
    }
    return highest;
}

/// Pa
double leastStress(const World& world) {
    double least = 0;
    for (const ElementLaw& law : world.laws())
        least = std::max(least, kLeastStrain * law.stressScale * law.youngModulus);
    return roundedUp(least);
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
    : world_(world),
      strength_(highestStrength(world)),
      stressEnd_(leastStress(world)),
      speedEnd_(kLeastSpeed) {}

void CellColours::continueScales(const CellColours& from) {
    stressEnd_ = std::max(stressEnd_, from.stressEnd_);
    speedEnd_ = std::max(speedEnd_, from.speedEnd_);
}

void CellColours::update(const State& state, WallColour colour) {
    key_ = {};
    key_.colour = colour;
    colours_.assign(colour == WallColour::Material ? 0 : world_.cellCount(), glm::vec4(0));
    switch (colour) {
        case WallColour::Material:
            break;
        case WallColour::Stress: {
            const std::vector<double> values = stresses(state);
            stressEnd_ = grown(stressEnd_, values);
            colourByScale(values, strength_ > 0 ? strength_ : stressEnd_);
            break;
        }
        case WallColour::Speed: {
            const std::vector<double> values = speeds(state);
            speedEnd_ = grown(speedEnd_, values);
            colourByScale(values, speedEnd_);
            break;
        }
        case WallColour::Piece:
            colourByPiece(state);
            break;
    }
}

std::vector<double> CellColours::stresses(const State& state) const {
    std::vector<double> values(world_.cellCount());
    for (int cell = 0; cell < world_.cellCount(); ++cell)
        if (world_.present(cell)) values[cell] = cellPrincipalStress(world_, state, cell);
    return values;
}

std::vector<double> CellColours::speeds(const State& state) const {
    std::vector<double> values(world_.cellCount());
    for (int cell = 0; cell < world_.cellCount(); ++cell)
        if (world_.present(cell)) values[cell] = cellSpeed(state, cell);
    return values;
}

void CellColours::colourByScale(const std::vector<double>& values, double end) {
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

}  // namespace sunder::render
