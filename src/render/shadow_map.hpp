#pragma once
#include <glm/glm.hpp>

#include "gl/program.hpp"
#include "render/scene_bounds.hpp"

namespace sunder::render {

/// Depth of the scene as the sun sees it, fitted to the bodies and the air around them. What flies
/// further casts no shadow.
class ShadowMap {
  public:
    /// `veiled`: something transparent may cast a light shadow.
    ShadowMap(const SceneBounds&, bool veiled);

    /// Binds an empty map and its viewport; what is then drawn with lightMatrix() casts a shadow.
    void begin() const;
    /// The same for what is transparent, drawn with draw/veil.frag and between these two.
    void beginVeil() const;
    static void endVeil();
    /// World to the map's clip space.
    const glm::mat4& lightMatrix() const { return lightMatrix_; }
    /// Once for a program that includes draw/shadow.glsl.
    static void prepare(const gl::Program&);
    /// Sets what draw/shadow.glsl reads, for the program in use, and binds the map.
    void bind(const gl::Program&) const;
    /// Once drawing is done: leaves no sampler object behind.
    static void unbind();

  private:
    int size_, veilSize_;
    glm::vec2 extent_;  ///< m, across the map and along its depth
    glm::mat4 lightMatrix_;
    gl::Texture depth_;
    gl::Sampler plain_;  ///< reads depths instead of comparing with them
    gl::Texture veil_;   ///< share of light that passes; from what depth on it is missing
    gl::Framebuffer framebuffer_, veilFramebuffer_;
};

}  // namespace sunder::render
