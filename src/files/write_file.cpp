#include "files/write_file.hpp"

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "core/types.hpp"
#include "files/temporary_file.hpp"

namespace sunder {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
    throw InputError(path.string() + ": cannot be written: " + reason);
}

std::string reasonOfLastError() {
    return errno ? std::generic_category().message(errno) : "unknown reason";
}

/// `named` is the path in messages.
void writeStraight(const fs::path& path, std::string_view bytes, const fs::path& named) {
    errno = 0;
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    if (file) {
        file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        // A full disk may show only now; closing a stream that failed hides why it did.
        if (file) file.close();
    }
    if (!file) fail(named, reasonOfLastError());
}

}  // namespace

void writeFile(const fs::path& path, std::string_view bytes) {
    std::error_code error;
    // A name too long for the file system, a folder that may not be read: writing will say so.
    fs::path target = path;
    if (fs::is_symlink(path, error)) target = fs::weakly_canonical(path, error);
    if (target.empty()) target = path;
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error))
        fail(path, "the folder " + folder.string() + " does not exist");
    if (!target.has_filename() || fs::is_directory(target, error)) fail(path, "it is a folder");
    if (fs::exists(target, error) && !fs::is_regular_file(target, error))
        return writeStraight(target, bytes, path);

    TemporaryFile temporary(target);
    writeStraight(temporary.path(), bytes, path);
    temporary.moveToTarget();
}

}  // namespace sunder
