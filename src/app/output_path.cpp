#include "app/output_path.hpp"

#include "core/types.hpp"
#include "files/utf8_path.hpp"
#include "files/write_file.hpp"

namespace sunder::app {

using namespace core;

namespace {

namespace fs = std::filesystem;

/// Two results would be one; a device or a pipe takes both.
bool sameFile(const fs::path& a, const fs::path& b) {
    std::error_code error;
    if (a.empty() || b.empty() || fs::is_other(fs::status(a, error))) return false;
    const auto plain = [&](const fs::path& path) {
        return fs::weakly_canonical(fs::absolute(path, error), error);
    };
    return plain(a) == plain(b);
}

}  // namespace

void checkOutputs(const std::vector<Output>& outputs) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        files::checkWritable(outputs[i].path);
        for (std::size_t j = 0; j < i; ++j)
            if (sameFile(outputs[i].path, outputs[j].path))
                throw InputError(outputs[j].option + " and " + outputs[i].option +
                                 " both write to '" + files::utf8FromPath(outputs[i].path) +
                                 "'; give each a file of its own");
    }
}

}  // namespace sunder::app
