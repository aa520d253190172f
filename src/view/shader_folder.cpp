#include "view/shader_folder.hpp"

#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "core/types.hpp"
#include "files/utf8_path.hpp"

namespace sunder::view {

using namespace core;

namespace fs = std::filesystem;

ShaderFolder::ShaderFolder(fs::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    if (!fs::is_directory(folder_ / "draw", error))
        throw InputError("--shader-dir: '" + files::utf8FromPath(folder_) +
                         "' is no folder of shaders; name a copy of Sunder's glsl/, which has a "
                         "folder draw in it");
    stamp_ = stamp();
}

template <class Visit>
void ShaderFolder::eachFile(Visit&& visit) const {
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder_, error), end; !error && at != end;
         at.increment(error)) {
        // An editor's own files come and go.
        const fs::path extension = at->path().extension();
        if (extension == ".glsl" || extension == ".vert" || extension == ".geom" ||
            extension == ".frag" || extension == ".h")
            visit(*at);
    }
}

gl::ShaderSource ShaderFolder::source() const {
    auto texts = std::make_shared<std::map<std::string, std::string, std::less<>>>();
    eachFile([&](const fs::directory_entry& entry) {
        std::ifstream file(entry.path(), std::ios::binary);
        if (!file) return;
        (*texts)[files::utf8FromPath(entry.path().lexically_relative(folder_))] =
            std::string(std::istreambuf_iterator<char>(file), {});
    });
    return [texts](std::string_view name) -> std::optional<std::string> {
        const auto text = texts->find(name);
        return text == texts->end() ? std::nullopt : std::optional(text->second);
    };
}

std::uint64_t ShaderFolder::stamp() const {
    // A sum over all files, whose order is not certain, tells also of one that went.
    std::uint64_t sum = 0;
    eachFile([&](const fs::directory_entry& entry) {
        std::error_code error;
        const auto time = entry.last_write_time(error);
        if (error) return;
        const auto ticks = static_cast<std::uint64_t>(time.time_since_epoch().count());
        sum += (ticks ^ fs::hash_value(entry.path())) * 0x9e3779b97f4a7c15u;
    });
    return sum;
}

bool ShaderFolder::changed() {
    const std::uint64_t now = stamp();
    return std::exchange(stamp_, now) != now;
}

}  // namespace sunder::view
