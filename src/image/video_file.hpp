#pragma once
#include <filesystem>

#include "files/temporary_file.hpp"
#include "image/fed_process.hpp"
#include "image/image.hpp"

namespace sunder::image {

/// A video that ffmpeg makes of frames as they come; its ending says which kind. All that goes
/// wrong, now or later, is an InputError, and then no file is left.
class VideoFile {
  public:
    /// Makes a video of two frames elsewhere and throws it away: what ffmpeg will not do (an
    /// ending, a size) is known before anything is simulated, and so is that it is not installed.
    static void check(const std::filesystem::path&, int width, int height, double fps);

    VideoFile(const std::filesystem::path&, int width, int height, double fps);

    /// Nothing any more once it was given up.
    void add(const Image&);
    /// The file is there after this. False: the user would not wait for it (signalledAgain()), and
    /// there is none.
    bool finish();
    /// The same, under FOLDER/NAME-001.mp4 where its path is FOLDER/NAME.mp4, or under the first
    /// number that nothing has yet; returns it, or an empty path.
    std::filesystem::path finishNumbered();

  private:
    VideoFile(const std::filesystem::path& target, const std::filesystem::path& named, int width,
              int height, double fps);
    bool close();
    [[noreturn]] void fail();

    std::filesystem::path named_;     ///< in messages
    files::TemporaryFile temporary_;  ///< outlives the process that writes it
    FedProcess ffmpeg_;
};

}  // namespace sunder::image
