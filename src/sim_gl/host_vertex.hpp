#pragma once
#include <array>
#include <string>

#include "gpu/world_buffers.hpp"

namespace sunder::sim_gl {

/// The vertex shader that Sunder draws with (glsl/draw/display.vert) as a function for a host's
/// own: GLSL 4.10 without `#version`. Every global name in it begins with sunder, whatever the case
/// of its letters. It holds for views with the strides of this one.
std::string hostVertexShader(const gpu::StateView&, bool turned);

/// A texture buffer that it reads, by the name of its sampler.
struct HostTexture {
    const char* sampler;
    GLuint texture;
};
inline constexpr int kHostTextures = 5;
std::array<HostTexture, kHostTextures> hostTextures(const gpu::WorldBuffers&,
                                                    const gpu::StateView&);

}  // namespace sunder::sim_gl
