#pragma once
#include <glm/glm.hpp>

#include "gpu/wall_state.hpp"

namespace sunder::render {

// Set a uniform of the program in use.
void setUniform(const gl::Program&, const char* name, const glm::mat4&);
void setUniform(const gl::Program&, const char* name, const glm::mat3&);
void setUniform(const gl::Program&, const char* name, const glm::vec2&);
void setUniform(const gl::Program&, const char* name, const glm::vec3&);
void setUniform(const gl::Program&, const char* name, const glm::vec4&);
void setUniform(const gl::Program&, const char* name, float);
void setUniform(const gl::Program&, const char* name, bool);

/// Texture units of the drawing shaders.
enum TextureUnit {
    kWallUnit,  ///< and those after it: gpu/wall_state.hpp
    kShadowUnit = kWallUnit + gpu::kWallUnits,
    kObjectUnit,
    kPlaceUnit,
    kShadowDepthUnit,
    kShadowVeilUnit,
    kSurfaceUnit,
    kLightSumUnit,
    kTransmissionUnit,
    kPaintUnit
};

}  // namespace sunder::render
