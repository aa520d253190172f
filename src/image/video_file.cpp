#include "image/video_file.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <system_error>

#include "core/types.hpp"
#include "files/system.hpp"
#include "files/utf8_path.hpp"

namespace sunder::image {

using namespace core;

namespace {

namespace fs = std::filesystem;

std::string decimal(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// Containers that take H.264, which every player knows.
bool takesH264(const fs::path& path) {
    std::string ending = files::utf8FromPath(path.extension());
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return ending == ".mp4" || ending == ".m4v" || ending == ".mov" || ending == ".mkv";
}

std::vector<std::string> command(const fs::path& path, int width, int height, double fps) {
    std::vector<std::string> words{"ffmpeg",    "-nostdin", "-hide_banner",
                                   "-loglevel", "error",    "-y"};
    const auto add = [&](std::initializer_list<std::string> more) {
        words.insert(words.end(), more);
    };
    add({"-f", "rawvideo", "-pixel_format", "rgb24"});
    add({"-video_size", std::to_string(width) + "x" + std::to_string(height)});
    add({"-framerate", decimal(fps), "-i", "pipe:0"});
    if (takesH264(path)) {
        // Two pixels share one colour: a black line more where the number is odd. The matrix that
        // players expect of anything sharp, said aloud: ffmpeg's own choice is that of old
        // television, and it keeps it to itself.
        add({"-vf",
             "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,"
             "format=yuv420p"});
        add({"-c:v", "libx264", "-crf", "18", "-colorspace", "bt709", "-color_primaries", "bt709",
             "-color_trc", "bt709", "-color_range", "tv"});
    }
    // Neither an option nor a protocol, whatever the name begins with.
    add({"file:" + files::utf8FromPath(path)});
    return words;
}

/// ffmpeg's first complaint, which is the cause (its last may be "Conversion failed!"), without the
/// part of it that spoke and its address.
std::string reason(const std::string& complaints) {
    std::istringstream lines(complaints);
    std::string line;
    std::getline(lines, line);
    if (const auto end = line.find("] "); line.starts_with('[') && end != std::string::npos)
        line.erase(0, end + 2);
    return line.empty() ? "it ended without a word" : line;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

}  // namespace

void VideoFile::check(const fs::path& path, int width, int height, double fps) {
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    if (error)
        throw InputError("a video cannot be made: there is no folder for temporary files: " +
                         error.message());
    VideoFile video(folder / fs::path("sunder").concat(path.extension().native()), path, width,
                    height, fps);
    const Image black{width, height, std::vector<std::uint8_t>(std::size_t{3} * width * height, 0)};
    // Two: some endings are those of single pictures.
    for (int frame = 0; frame < 2; ++frame) video.add(black);
    video.close();
}

VideoFile::VideoFile(const fs::path& path, int width, int height, double fps)
    : VideoFile(path, path, width, height, fps) {}

VideoFile::VideoFile(const fs::path& target, const fs::path& named, int width, int height,
                     double fps)
    : named_(named), temporary_(target), ffmpeg_(command(temporary_.path(), width, height, fps)) {
    if (!ffmpeg_.started())
        throw InputError("a video needs ffmpeg, which is not installed; install it (" +
                         files::installCommand("ffmpeg") +
                         "), or make pictures instead (`sunder run SCENE --frames-png 1`)");
}

void VideoFile::add(const Image& image) {
    const bool taken =
        ffmpeg_.feed({reinterpret_cast<const char*>(image.pixels.data()), image.pixels.size()});
    if (!taken && !ffmpeg_.givenUp()) fail();
}

bool VideoFile::finish() {
    if (!close()) return false;
    temporary_.moveToTarget();
    return true;
}

fs::path VideoFile::finishNumbered() {
    return close() ? temporary_.moveToNextNumber() : fs::path();
}

bool VideoFile::close() {
    const bool well = ffmpeg_.close();
    if (ffmpeg_.givenUp()) return false;
    // On a full disk ffmpeg complains, leaves a part of the video, and ends as if all were well.
    if (!well || !ffmpeg_.complaints().empty()) fail();
    return true;
}

void VideoFile::fail() {
    ffmpeg_.close();
    throw InputError("ffmpeg cannot write '" + files::utf8FromPath(named_) + "': " +
                     replaced(reason(ffmpeg_.complaints()),
                              "file:" + files::utf8FromPath(temporary_.path()),
                              files::utf8FromPath(named_)));
}

}  // namespace sunder::image
