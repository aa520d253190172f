#include "view/shader_folder.hpp"

#include <fstream>
#include <iterator>
#include <utility>

#include "core/types.hpp"

namespace sunder::view {

namespace fs = std::filesystem;

ShaderFolder::ShaderFolder(fs::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    if (!fs::is_directory(folder_ / "draw", error))
        throw InputError("--shader-dir: '" + folder_.string() +
                         "' is no folder of shaders; name a copy of Sunder's glsl/, which has a "
                         "folder draw in it");
    stamp_ = stamp();
}

gl::ShaderSource ShaderFolder::source() const {
    return [folder = folder_](std::string_view name) -> std::optional<std::string> {
        std::ifstream file(folder / name, std::ios::binary);
        if (!file) return std::nullopt;
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
}

std::uint64_t ShaderFolder::stamp() const {
    // A sum over all files, whose order is not certain, tells also of one that went.
    std::uint64_t sum = 0;
    std::error_code error;
    for (fs::recursive_directory_iterator at(folder_, error), end; at != end; at.increment(error)) {
        if (error) break;
        const auto time = at->last_write_time(error);
        // An editor's own files come and go.
        const std::string extension = at->path().extension().string();
        const bool shader = extension == ".glsl" || extension == ".vert" || extension == ".geom" ||
                            extension == ".frag" || extension == ".h";
        if (error || !shader) continue;
        const auto ticks = static_cast<std::uint64_t>(time.time_since_epoch().count());
        sum += (ticks ^ fs::hash_value(at->path())) * 0x9e3779b97f4a7c15u;
    }
    return sum;
}

bool ShaderFolder::changed() {
    const std::uint64_t now = stamp();
    return std::exchange(stamp_, now) != now;
}

}  // namespace sunder::view
