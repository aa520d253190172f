#pragma once
#include <glm/glm.hpp>

#include "gl/program.hpp"
#include "render/scene_bounds.hpp"

namespace sunder {

/// Depth of the scene as the sun sees it, fitted to the bodies and the air around them. What flies
/// further casts no shadow.
class ShadowMap {
  public:
    explicit ShadowMap(const SceneBounds&);

    /// Binds an empty map and its viewport; what is then drawn with lightMatrix() casts a shadow.
    void begin() const;
    /// World to the map's clip space.
    const glm::mat4& lightMatrix() const { return lightMatrix_; }
    /// Sets what draw/shadow.glsl reads, for the program in use, and binds the map.
    void bind(const gl::Program&) const;

  private:
    int size_;
    float texel_;  ///< m
    glm::mat4 lightMatrix_;
    gl::Texture depth_;
    gl::Framebuffer framebuffer_;
};

}  // namespace sunder
