#include "files/temporary_file.hpp"

#include <random>
#include <string>
#include <system_error>

#include "core/types.hpp"

namespace sunder {
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

}  // namespace

TemporaryFile::TemporaryFile(fs::path target)
    : target_(std::move(target)), path_(temporaryName(target_)) {}

TemporaryFile::~TemporaryFile() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove(path_, ignored);
}

void TemporaryFile::moveToTarget() {
    std::error_code error;
    fs::rename(path_, target_, error);
    if (error) throw InputError(target_.string() + ": cannot be written: " + error.message());
    path_.clear();
}

}  // namespace sunder
