#include "files/temporary_file.hpp"

#include <cstdio>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include "core/types.hpp"
#include "files/system.hpp"
#include "files/utf8_path.hpp"

namespace sunder::files {

using namespace core;

namespace {

namespace fs = std::filesystem;

/// Random, so that two programs may write at once. A dot in front: *.png is whole pictures only,
/// also after this program was killed.
fs::path temporaryName(const fs::path& target) {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::random_device random;
    std::string mark = ".tmp-";
    for (int i = 0; i < 12; ++i) mark += kDigits[random() & 15u];
    fs::path name = ".";
    name += target.stem();
    name += mark;
    name += target.extension();
    return target.parent_path() / name;
}

[[noreturn]] void fail(const fs::path& target, const std::error_code& reason) {
    throw InputError(utf8FromPath(target) + ": cannot be written: " + reason.message());
}

}  // namespace

TemporaryFile::TemporaryFile(fs::path target)
    : target_(std::move(target)), path_(temporaryName(target_)) {}

TemporaryFile::~TemporaryFile() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove(path_, ignored);
}

void TemporaryFile::make() {
    if (const std::error_code error = makeNewFile(path_)) fail(target_, error);
}

void TemporaryFile::moveToTarget() {
    std::error_code error;
    fs::rename(path_, target_, error);
    if (error) fail(target_, error);
    path_.clear();
}

bool TemporaryFile::moveToNew(const fs::path& target) {
    std::error_code error;
    // A second name for the same file, which a system gives only where there is none such.
    fs::create_hard_link(path_, target, error);
    if (error == std::errc::file_exists) return false;
    if (!error) {
        fs::remove(std::exchange(path_, {}), error);
        return true;
    }
    // Some file systems know no second names. There an empty file holds the place for a moment.
    error = makeNewFile(target);
    if (error == std::errc::file_exists) return false;
    if (error) fail(target, error);
    fs::rename(path_, target, error);
    if (error) {
        std::error_code ignored;
        fs::remove(target, ignored);
        fail(target, error);
    }
    path_.clear();
    return true;
}

fs::path TemporaryFile::moveToNextNumber() {
    for (int number = 1;; ++number) {
        char digits[16];
        std::snprintf(digits, sizeof digits, "-%03d", number);
        fs::path name = target_.stem();
        name += digits;
        name += target_.extension();
        name = target_.parent_path() / name;
        if (moveToNew(name)) return name;
    }
}

}  // namespace sunder::files
