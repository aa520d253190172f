#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "image/comparison.hpp"
#include "render/cell_colours.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

/// One picture of tests/image/suite.toml.
struct SuitePicture {
    std::string name, scene;
    int frame = 0;
    sunder::RenderSettings settings;
    sunder::WallColour colour = sunder::WallColour::Material;
};

struct Suite {
    std::string baselineRenderer;  ///< how GL_RENDERER begins of the driver that made the baselines
    sunder::ComparisonLimits baselineLimits, otherLimits;
    std::vector<SuitePicture> pictures;
};

/// Throws InputError naming the line of what is wrong.
Suite readSuite(const std::filesystem::path&);

/// Draws a picture of the suite in the test case's context, of the scene as `change` leaves it.
sunder::Image drawSuitePicture(
    const SuitePicture&, const std::function<void(sunder::Scene&)>& change = [](sunder::Scene&) {});
