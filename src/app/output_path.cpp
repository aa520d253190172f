#include "app/output_path.hpp"

#include "core/types.hpp"

namespace sunder::app {

namespace fs = std::filesystem;

void checkWritable(const fs::path& path, const fs::path& out) {
    if (path.empty()) return;
    std::error_code error;
    if (fs::is_directory(path, error))
        throw InputError("cannot write '" + path.string() + "': it is a folder");
    const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
    const auto plain = [](const fs::path& p) { return (p / "").lexically_normal(); };
    if (!fs::is_directory(folder, error) && (out.empty() || plain(folder) != plain(out)))
        throw InputError("cannot write '" + path.string() + "': there is no folder '" +
                         folder.string() + "'");
}

}  // namespace sunder::app
