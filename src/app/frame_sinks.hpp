#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include "app/run_options.hpp"
#include "image/image.hpp"
#include "scene/scene.hpp"

namespace sunder::app {

/// One frame of a run, drawn.
struct Frame {
    int number;
    double time;  ///< s
    image::Image plain;
    render::ColourKey key;
    image::Image withLegend;  ///< the same as plain where there is nothing to explain
};

/// Where frames go.
class FrameSink {
  public:
    virtual ~FrameSink() = default;
    virtual bool wants(int frame) const = 0;
    virtual void take(const Frame&) = 0;
    /// After the last frame, also of a run that was interrupted before it.
    virtual void finish() {}
    /// What became of it where a run was interrupted, for a sentence; empty: nothing to say.
    virtual std::string outcome() const { return {}; }
};

/// Every sink that the options ask for, of a run whose `frames` of 1/fps s follow number 0. Throws
/// InputError for what will not be possible; no file is there yet.
std::vector<std::unique_ptr<FrameSink>> makeFrameSinks(const RunOptions&,
                                                       const core::WorldDescription&,
                                                       const render::RenderSettings&, int frames);

}  // namespace sunder::app
