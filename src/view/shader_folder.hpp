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

    /// Reads them as they are when they are asked for.
    gl::ShaderSource source() const;
    /// Whether a file has changed, come or gone since the last call.
    bool changed();

  private:
    std::uint64_t stamp() const;

    std::filesystem::path folder_;
    std::uint64_t stamp_ = 0;
};

}  // namespace sunder::view
