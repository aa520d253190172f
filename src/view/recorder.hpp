#pragma once
#include <filesystem>
#include <string>

#include "image/video_file.hpp"

namespace sunder::view {

/// FOLDER/NAME-001.png, or the first number that no file has yet.
std::filesystem::path freshFile(const std::filesystem::path& folder, const std::string& name,
                                const std::string& ending);

/// A video of the frames that it is given, 60 a second.
class Recorder {
  public:
    /// Throws InputError for what VideoFile refuses.
    Recorder(const std::filesystem::path&, int width, int height);

    /// False, and the video is over, when the picture has another size than the first.
    bool add(const Image&);
    void finish() { video_.finish(); }
    const std::filesystem::path& path() const { return path_; }
    int frames() const { return frames_; }

  private:
    std::filesystem::path path_;
    int width_, height_, frames_ = 0;  // even: video formats ask for it
    VideoFile video_;
};

}  // namespace sunder::view
