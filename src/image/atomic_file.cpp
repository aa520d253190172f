#include <cerrno>
#include <fstream>
#include <system_error>

#include "core/types.hpp"
#include "image/image.hpp"
#include "image/temporary_file.hpp"

namespace sunder {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
    throw InputError(path.string() + ": cannot be written: " + reason);
}

std::string reasonOfLastError() {
    return errno ? std::generic_category().message(errno) : "unknown reason";
}

}  // namespace

void writeFileAtomically(const fs::path& path, std::string_view contents) {
    std::error_code error;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error))
        fail(path, "the folder " + folder.string() + " does not exist");
    if (!path.has_filename() || fs::is_directory(path, error)) fail(path, "it is a folder");

    TemporaryFile temporary(path);
    errno = 0;
    std::ofstream file(temporary.path(), std::ios::binary | std::ios::trunc);
    if (file) {
        file.write(contents.data(), static_cast<std::streamsize>(contents.size()));
        file.close();
    }
    if (!file) fail(path, reasonOfLastError());

    temporary.moveToTarget();
}

}  // namespace sunder
