#pragma once
#include <filesystem>

#include "files/held_signals.hpp"

namespace sunder::files {

/// A file to be: a name beside `target` that nobody else has, with the target's ending. What was
/// written there goes when this goes, unless it was moved. Beside it, so that moving stays within
/// one file system. A signal that would end the program waits until then, so that it leaves nothing
/// either.
class TemporaryFile {
  public:
    /// Makes no file yet.
    explicit TemporaryFile(std::filesystem::path target);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Makes it, empty; whoever writes it may also do that. Throws InputError naming target and
    /// reason.
    void make();
    /// Replaces the target. Throws InputError naming target and reason.
    void moveToTarget();
    /// False, and nothing happened: there is such a file already. However many do this at once, one
    /// of them gets the name. Throws InputError as above.
    bool moveToNew(const std::filesystem::path&);
    /// To FOLDER/NAME-001.png where the target is FOLDER/NAME.png, or to the first number that
    /// nothing has yet; returns it. Throws InputError as above.
    std::filesystem::path moveToNextNumber();

  private:
    HeldSignals held_;
    std::filesystem::path target_, path_;
};

}  // namespace sunder::files
