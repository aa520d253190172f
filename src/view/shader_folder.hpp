#pragma once
#include <cstdint>
#include <filesystem>

#include "gl/shader_assembly.hpp"

namespace sunder::view {

/// The files under a copy of glsl/, for whoever writes shaders while they run.
class ShaderFolder {
  public:
    /// Throws InputError when there is no such folder, or it is not one of shaders.
    explicit ShaderFolder(std::filesystem::path);

    /// All of them as they are now, whatever happens to the files later.
    gl::ShaderSource source() const;
    /// Whether a file has changed, come or gone since the last call.
    bool changed();

  private:
    std::uint64_t stamp() const;
    template <class Visit>
    void eachFile(Visit&&) const;

    std::filesystem::path folder_;
    std::uint64_t stamp_ = 0;
};

}  // namespace sunder::view
