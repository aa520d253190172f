#pragma once
#include <filesystem>

#include "image/video_file.hpp"

namespace sunder::view {

/// A video of the frames that it is given, 60 a second.
class Recorder {
  public:
    /// `path` is that of its name without a number. Throws InputError for what VideoFile refuses.
    Recorder(const std::filesystem::path&, int width, int height);

    /// False, and the video is over, when the picture has another size than the first.
    bool add(const image::Image&);
    /// As VideoFile::finishNumbered().
    std::filesystem::path finish() { return video_.finishNumbered(); }
    int frames() const { return frames_; }

  private:
    int width_, height_, frames_ = 0;  // even: video formats ask for it
    image::VideoFile video_;
};

}  // namespace sunder::view
