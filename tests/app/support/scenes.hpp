#pragma once
#include <string>

/// Scenes of 6 × 4 × 1 cells, which take no time; and some at the limits.
namespace scenes {

inline const std::string kBody =
    "[[body]]\n"
    "name = 'wall'\n"
    "material = 'soft'\n"
    "size = [0.6, 0.4, 0.1]\n"
    "cells = [6, 4, 1]\n";

/// 6·4·1 cells have (5·4 + 6·3)·1 inner faces.
inline constexpr int kCells = 24, kBonds = 38;

/// Soft enough for every step, too strong to break; it falls and does not reach the ground.
inline const std::string kFalling =
    "frames = 5\n"
    "[material.soft]\n"
    "young_modulus = 1e5\n"
    "strength = 1e12\n"
    "damping = 0\n" +
    kBody + "position = [0, 1, 0]\n";

/// Stiffer than the step carries, and it breaks: strengths scatter, so the seed decides where.
inline const std::string kBreaking =
    "frames = 5\n"
    "[material.soft]\n"
    "young_modulus = 1e10\n"
    "strength = 1e6\n"
    "spread = 0.5\n" +
    kBody +
    "anchor = ['bottom']\n"
    "[[event]]\n"
    "time = 0\n"
    "kind = 'velocity'\n"
    "body = 'wall'\n"
    "point = [0, 0.3, 0.05]\n"
    "radius = 0.15\n"
    "vector = [0, 0, -40]\n";

/// `size` and `cells` as a scene file has them; one frame.
inline std::string wall(const std::string& size, const std::string& cells) {
    return "frames = 1\n[[body]]\nname = 'wall'\nmaterial = 'rubber'\nsize = " + size +
           "\ncells = " + cells + "\n";
}

/// 400,000 cells, a single substep.
inline const std::string kTwoMillion =
    "solver = {substeps = 1}\n" + wall("[50, 40, 0.2]", "[500, 400, 2]");

}  // namespace scenes
