#include "app/output_folder.hpp"

#include <algorithm>
#include <string>

#include "core/types.hpp"
#include "files/utf8_path.hpp"

namespace sunder::app {

using namespace core;

namespace fs = std::filesystem;

OutputFolder::OutputFolder(const fs::path& path) {
    try {
        make(path);
        claim_ = std::make_unique<files::FolderClaim>(path);
        if (!claim_->held())
            throw InputError("--out: another `sunder run` is writing into '" +
                             files::utf8FromPath(path) + "'; give this one a folder of its own");
    } catch (...) {
        removeEmpty();
        throw;
    }
}

OutputFolder::~OutputFolder() {
    removeEmpty();
}

void OutputFolder::make(const fs::path& path) {
    std::error_code error;
    std::vector<fs::path> missing;
    for (fs::path p = path; !p.empty() && !fs::is_directory(p, error); p = p.parent_path())
        missing.push_back(p);
    std::reverse(missing.begin(), missing.end());
    for (const fs::path& folder : missing) {
        if (fs::create_directory(folder, error)) made_.push_back(folder);
        if (error)
            throw InputError("--out: cannot make the folder '" + files::utf8FromPath(path) +
                             "': " + error.message());
    }
}

void OutputFolder::removeEmpty() {
    std::error_code ignored;
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder)
        fs::remove(*folder, ignored);
}

}  // namespace sunder::app
