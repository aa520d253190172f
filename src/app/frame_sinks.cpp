#include "app/frame_sinks.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "app/sheet_frames.hpp"
#include "files/utf8_path.hpp"
#include "files/write_file.hpp"
#include "image/contact_sheet.hpp"
#include "image/scaling.hpp"
#include "image/video_file.hpp"
#include "render/legend.hpp"

namespace sunder::app {

using namespace core;

namespace {

namespace fs = std::filesystem;

/// DIR/frame_0000.png, …
class PngFrames : public FrameSink {
  public:
    PngFrames(fs::path folder, int every, int last)
        : folder_(std::move(folder)), every_(every), last_(last) {
        std::error_code error;
        if (!fs::is_directory(folder_, error)) return;
        for (int frame = 0; frame <= last_; ++frame)
            if (wants(frame) && fs::is_directory(path(frame), error))
                files::checkWritable(path(frame));
    }
    bool wants(int frame) const override { return frame % every_ == 0 || frame == last_; }
    void take(const Frame& frame) override {
        image::writePng(path(frame.number), frame.withLegend);
    }

  private:
    fs::path path(int frame) const {
        char name[32];
        std::snprintf(name, sizeof name, "frame_%04d.png", frame);
        return folder_ / name;
    }

    fs::path folder_;
    int every_, last_;
};

class VideoFrames : public FrameSink {
  public:
    VideoFrames(fs::path path, double fps) : path_(std::move(path)), fps_(fps) {}
    bool wants(int) const override { return true; }
    void take(const Frame& frame) override {
        const image::Image& image = frame.withLegend;
        // Not before: the folder may be the run's own, which is made last.
        if (!video_) video_.emplace(path_, image.width, image.height, fps_);
        video_->add(image);
    }
    void finish() override { there_ = video_ && video_->finish(); }
    std::string outcome() const override {
        if (!video_) return "there is no video";
        return "the video '" + files::utf8FromPath(path_) +
               (there_ ? "' ends there" : "' was given up");
    }

  private:
    fs::path path_;
    double fps_;
    bool there_ = false;
    std::optional<image::VideoFile> video_;
};

class SheetFrames : public FrameSink {
  public:
    SheetFrames(fs::path path, std::vector<int> frames, const render::RenderSettings& settings,
                double fps)
        : path_(std::move(path)),
          frames_(std::move(frames)),
          layout_(static_cast<int>(frames_.size()), settings.width, settings.height),
          sheet_(layout_),
          decimals_(fps > 100 ? 3 : 2) {}
    bool wants(int frame) const override {
        return std::binary_search(frames_.begin(), frames_.end(), frame);
    }
    void take(const Frame& frame) override {
        // The legend comes last: scaled down with the picture it could not be read.
        image::Image tile = image::scaledDown(frame.plain, layout_.tileWidth, layout_.tileHeight);
        render::drawLegend(tile, frame.key);
        char time[32];
        std::snprintf(time, sizeof time, "%.*f s", decimals_, frame.time);
        sheet_.add(tile, time);
        ++taken_;
    }
    void finish() override {
        if (whole()) image::writePng(path_, sheet_.image());
    }
    std::string outcome() const override { return whole() ? "" : "there is no contact sheet"; }

  private:
    bool whole() const { return taken_ == frames_.size(); }

    fs::path path_;
    std::vector<int> frames_;
    image::SheetLayout layout_;
    image::ContactSheet sheet_;
    int decimals_;
    std::size_t taken_ = 0;
};

}  // namespace

std::vector<std::unique_ptr<FrameSink>> makeFrameSinks(const RunOptions& options,
                                                       const WorldDescription& world,
                                                       const render::RenderSettings& settings,
                                                       int frames) {
    std::vector<std::unique_ptr<FrameSink>> sinks;
    if (options.pngEvery > 0)
        sinks.push_back(std::make_unique<PngFrames>(options.out, options.pngEvery, frames));
    if (!options.contactSheet.empty())
        sinks.push_back(std::make_unique<SheetFrames>(
            options.contactSheet,
            options.sheetTimes.empty() ? storyFrames(world, frames, options.fps)
                                       : framesAt(options.sheetTimes, frames, options.fps),
            settings, options.fps));
    if (!options.video.empty()) {
        image::VideoFile::check(options.video, settings.width, settings.height, options.fps);
        sinks.push_back(std::make_unique<VideoFrames>(options.video, options.fps));
    }
    return sinks;
}

}  // namespace sunder::app
