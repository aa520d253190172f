#pragma once
#include <filesystem>

namespace sunder {

/// A file to be: a name beside `target` that nobody else has, with the target's ending. What was
/// written there goes when this goes, unless it was moved to the target. Beside it, so that moving
/// stays within one file system.
class TemporaryFile {
  public:
    /// Makes no file yet.
    explicit TemporaryFile(std::filesystem::path target);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Replaces the target. Throws InputError naming target and reason.
    void moveToTarget();

  private:
    std::filesystem::path target_, path_;
};

}  // namespace sunder
