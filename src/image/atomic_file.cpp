#include <cerrno>
#include <fstream>
#include <random>
#include <system_error>

#include "core/types.hpp"
#include "image/image.hpp"

namespace sunder {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
    throw InputError(path.string() + ": cannot be written: " + reason);
}

std::string reasonOfLastError() {
    return errno ? std::generic_category().message(errno) : "unknown reason";
}

/// Beside `path`, so that renaming stays within one file system; random, so that two programs may
/// write at once.
fs::path temporaryName(const fs::path& path) {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::random_device random;
    fs::path name = path;
    std::string suffix = ".tmp-";
    for (int i = 0; i < 12; ++i) suffix += kDigits[random() & 15u];
    name += suffix;
    return name;
}

/// Removes a file unless told that it has been renamed.
class TemporaryFile {
  public:
    explicit TemporaryFile(fs::path path) : path_(std::move(path)) {}
    ~TemporaryFile() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const fs::path& path() const { return path_; }
    void release() { path_.clear(); }

  private:
    fs::path path_;
};

}  // namespace

void writeFileAtomically(const fs::path& path, std::string_view contents) {
    std::error_code error;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error))
        fail(path, "the folder " + folder.string() + " does not exist");
    if (!path.has_filename() || fs::is_directory(path, error)) fail(path, "it is a folder");

    TemporaryFile temporary(temporaryName(path));
    errno = 0;
    std::ofstream file(temporary.path(), std::ios::binary | std::ios::trunc);
    if (file) {
        file.write(contents.data(), static_cast<std::streamsize>(contents.size()));
        file.close();
    }
    if (!file) fail(path, reasonOfLastError());

    fs::rename(temporary.path(), path, error);
    if (error) fail(path, error.message());
    temporary.release();
}

}  // namespace sunder
