#pragma once
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

namespace sunder::view {

/// `sunder view --log`: a JSON object per line, for tests and bug reports. Nothing without a file.
class EventLog {
  public:
    EventLog() = default;
    /// Throws InputError when it cannot be written.
    explicit EventLog(const std::filesystem::path&);

    bool enabled() const { return file_.has_value(); }
    /// What happens from now on happens in this frame.
    void beginFrame(std::int64_t frame) { frame_ = frame; }
    /// `{"event": name, "frame": …, …}`, there at once for whoever reads along. Says once on stderr
    /// that it cannot be written, and the log ends.
    void add(const char* name, nlohmann::ordered_json fields = nlohmann::ordered_json::object());

  private:
    std::filesystem::path path_;
    std::optional<std::ofstream> file_;
    std::int64_t frame_ = 0;
};

}  // namespace sunder::view
