#include "files/write_file.hpp"

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "core/types.hpp"
#include "files/temporary_file.hpp"
#include "files/utf8_path.hpp"

namespace sunder::files {

using namespace core;

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
    throw InputError(utf8FromPath(path) + ": cannot be written: " + reason);
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

/// A device, a pipe: it is there and cannot be replaced.
bool isStream(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

/// Where a file lies or will lie. Throws InputError naming `path` where there cannot be one.
fs::path placeOf(const fs::path& path) {
    std::error_code error;
    // A name too long for the file system, a folder that may not be read: writing will say so.
    fs::path place = path;
    if (fs::is_symlink(path, error)) place = fs::weakly_canonical(path, error);
    if (place.empty()) place = path;
    const fs::path folder = place.has_parent_path() ? place.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error))
        fail(path, fs::exists(folder, error) ? "'" + utf8FromPath(folder) + "' is not a folder"
                                             : "there is no folder '" + utf8FromPath(folder) +
                                                   "'; one that does not exist is not made");
    if (!place.has_filename() || fs::is_directory(place, error)) fail(path, "it is a folder");
    return place;
}

/// Opens it as writing would, and adds nothing. Not a pipe: its reader would take that for its end.
void checkStream(const fs::path& path) {
    std::error_code error;
    if (fs::is_fifo(path, error)) return;
    errno = 0;
    if (!std::ofstream(path, std::ios::binary | std::ios::app)) fail(path, reasonOfLastError());
}

}  // namespace

void writeFile(const fs::path& path, std::string_view bytes) {
    if (isStream(path)) return writeStraight(path, bytes, path);
    TemporaryFile temporary(placeOf(path));
    writeStraight(temporary.path(), bytes, path);
    temporary.moveToTarget();
}

bool writeNewFile(const fs::path& path, std::string_view bytes) {
    TemporaryFile temporary(placeOf(path));
    writeStraight(temporary.path(), bytes, path);
    return temporary.moveToNew(path);
}

fs::path writeNumberedFile(const fs::path& path, std::string_view bytes) {
    TemporaryFile temporary(placeOf(path));
    writeStraight(temporary.path(), bytes, path);
    return temporary.moveToNextNumber();
}

void checkWritable(const fs::path& path) {
    if (path.empty()) return;
    if (isStream(path)) return checkStream(path);
    TemporaryFile(placeOf(path)).make();
}

}  // namespace sunder::files
