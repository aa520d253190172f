#pragma once
#include <vector>

#include "scene/scene.hpp"

namespace sunder::app {

/// Frames on a contact sheet, unless told which.
inline constexpr int kSheetFrames = 12;

/// Numbers of the frames that tell a run's story, in order, each once: from the one before the
/// first event or throw (the beginning, where there is none) to the last. `frames` of 1/fps s
/// follow number 0.
std::vector<int> storyFrames(const core::WorldDescription&, int frames, double fps);

/// Those nearest to the times (s). Throws InputError for a time that the run does not reach.
std::vector<int> framesAt(const std::vector<double>& times, int frames, double fps);

}  // namespace sunder::app
