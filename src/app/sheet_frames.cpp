#include "app/sheet_frames.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace sunder::app {

using namespace core;

namespace {

/// More would be too small to see anything, and a list of hundreds is a slip.
constexpr std::size_t kMostFrames = 64;

/// When the first and the last event or throw begins, s; 0 where there is none.
struct Actions {
    double first = 0, last = 0;
    int count = 0;

    explicit Actions(const WorldDescription& world) {
        for (const EventDescription& event : world.events) take(event.time);
        for (const ThrowDescription& thrown : world.throws) take(thrown.time);
    }
    void take(double time) {
        first = count ? std::min(first, time) : time;
        last = std::max(last, time);
        ++count;
    }
};

std::string seconds(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g s", value);
    return text;
}

std::vector<int> inOrder(std::vector<int> frames) {
    std::sort(frames.begin(), frames.end());
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

}  // namespace

std::vector<int> storyFrames(const WorldDescription& world, int frames, double fps) {
    const Actions actions(world);
    // An event at the very time of a frame shows from the next one on.
    const int first =
        static_cast<int>(std::min(std::floor(actions.first * fps + 1e-6), double(frames)));
    // What one blow breaks, it breaks at once; then it falls for long. So the steps grow evenly.
    // Where more happens, or nobody knows when, they are equal.
    const double exponent = actions.count > 0 && actions.first == actions.last ? 2 : 1;
    std::vector<int> result;
    for (int i = 0; i < kSheetFrames; ++i) {
        const double part = std::pow(static_cast<double>(i) / (kSheetFrames - 1), exponent);
        const int frame = first + static_cast<int>(std::lround(part * (frames - first)));
        // In a short run the first steps would be less than a frame each.
        result.push_back(std::min(std::max(frame, first + i), frames));
    }
    return inOrder(result);
}

std::vector<int> framesAt(const std::vector<double>& times, int frames, double fps) {
    if (times.size() > kMostFrames)
        throw InputError("--sheet-times: " + std::to_string(times.size()) + " are too many (" +
                         std::to_string(kMostFrames) + " at most)");
    std::vector<int> result;
    for (const double time : times) {
        const double frame = std::round(time * fps);
        if (!(frame >= 0 && frame <= frames))
            throw InputError("--sheet-times: " + seconds(time) +
                             " is not within the run, which lasts " + seconds(frames / fps));
        result.push_back(static_cast<int>(frame));
    }
    return inOrder(result);
}

}  // namespace sunder::app
