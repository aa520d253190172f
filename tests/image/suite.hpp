#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image/comparison.hpp"
#include "render/cell_colours.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"
#include "window/context.hpp"

/// Whose state a picture shows.
enum class SuiteSolver {
    Cpu,  ///< a stored state (image/stored_state.hpp)
    Gather,
    Scatter,  ///< these simulate, and are drawn from their own buffers
};

std::string_view toString(SuiteSolver);

/// One picture of tests/image/suite.toml.
struct SuitePicture {
    std::string name, scene;
    int frame = 0;
    SuiteSolver solver = SuiteSolver::Cpu;
    std::string baseline;  ///< the picture whose baseline it is compared with
    sunder::render::RenderSettings settings;
    sunder::render::WallColour colour = sunder::render::WallColour::Material;
    std::optional<sunder::core::Vec3> camera, target;  ///< m, instead of the scene's
    /// Instead of the suite's limits.
    std::optional<int> threshold;
    std::optional<double> share, window, mean;

    bool ownBaseline() const { return baseline == name; }
    /// The initial state is nobody's to store.
    bool storedState() const { return solver == SuiteSolver::Cpu && frame > 0; }
};

struct Suite {
    std::string baselineRenderer;  ///< how GL_RENDERER begins of the driver that made the baselines
    std::string baselineVersion;   ///< what its GL_VERSION contains
    sunder::image::ComparisonLimits baselineLimits, otherLimits;
    std::vector<SuitePicture> pictures;

    /// Throws InputError.
    const SuitePicture& picture(const std::string& name) const;
    bool madeBaselines(const sunder::gl::DeviceInfo&) const;
    /// Of the driver. A picture's own hold on the baseline driver; elsewhere the wider of both.
    sunder::image::ComparisonLimits limits(const SuitePicture&,
                                           const sunder::gl::DeviceInfo&) const;
};

/// Throw InputError naming the line of what is wrong.
Suite readSuite(const std::filesystem::path&);
Suite parseSuite(std::string_view text, const std::string& file);

/// Of the folder tests/image, or one like it.
std::filesystem::path baselineOf(const std::filesystem::path& folder, const SuitePicture&);
/// Pictures of the same scene and frame share one.
std::filesystem::path stateOf(const std::filesystem::path& folder, const SuitePicture&);

using SceneChange = std::function<void(sunder::scene::Scene&)>;

/// Draws a picture of the suite in the test case's context, of the scene as `change` leaves it.
/// Throws StateError where it cannot read the state.
sunder::image::Image drawSuitePicture(
    const SuitePicture&, const std::filesystem::path& folder,
    const SceneChange& change = [](sunder::scene::Scene&) {});
