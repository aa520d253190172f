#pragma once
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "core/world.hpp"

namespace sunder::render {

/// What the colour of walls shows.
enum class WallColour {
    Material,
    Stress,  ///< largest principal Cauchy stress in a cell, as the .vtu has it
    Speed,   ///< of a cell's centre of mass
    Piece,   ///< which cells hang together
};
inline constexpr WallColour kWallColours[] = {WallColour::Material, WallColour::Stress,
                                              WallColour::Speed, WallColour::Piece};
/// As the command line calls them.
std::string_view toString(WallColour);

/// What a legend has to say about a picture's colours (render/legend.hpp).
struct ColourKey {
    WallColour colour = WallColour::Material;
    double end = 0;  ///< Pa or m/s at the bar's bright end; the dark one is 0
    int pieces = 0;
};

/// Colours of a world's cells, worked out on the CPU from a state: a view for finding things out,
/// not one for games.
///
/// The scale of stress ends at the highest strength of the world's materials, which is what these
/// stresses are compared with: bright is about to break, and the scale is the same in every picture
/// of a run. A world that does not break, and speeds, have no such limit. There it ends at the
/// largest value seen so far, rounded up to 1, 2 or 5 times a power of ten: it changes a few times
/// in a run, and never flickers.
class CellColours {
  public:
    /// The world must outlive it.
    explicit CellColours(const core::World&);
    void update(const core::State&, WallColour);
    /// The scales go on from those of another world.
    void continueScales(const CellColours& from);

    /// Linear RGB, 1, per cell, absent ones 0. Empty: the materials' own.
    const std::vector<glm::vec4>& colours() const { return colours_; }
    const ColourKey& key() const { return key_; }

  private:
    std::vector<double> stresses(const core::State&) const;  ///< Pa, per cell; 0 in absent ones
    std::vector<double> speeds(const core::State&) const;    ///< m/s
    void colourByScale(const std::vector<double>& values, double end);
    void colourByPiece(const core::State&);

    const core::World& world_;
    std::vector<glm::vec4> colours_;
    ColourKey key_;
    double strength_;              ///< Pa, the highest; 0: nothing breaks
    double stressEnd_, speedEnd_;  ///< Pa, m/s, of what has been seen
};

}  // namespace sunder::render
