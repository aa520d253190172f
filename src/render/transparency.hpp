#pragma once
#include <functional>

#include "gl/program.hpp"
#include "render/picture_target.hpp"

namespace sunder::render {

/// Draws what lets light through, in whatever order it comes: weighted blended order-independent
/// transparency (McGuire and Bavoil 2013). How much of the light behind arrives is exact for any
/// number of layers; their own light is averaged with weights that fall with the distance.
class Transparency {
  public:
    explicit Transparency(const gl::VertexArray& noAttributes);

    /// Over the opaque picture in `target`, whose framebuffer is bound, now and afterwards. `pass`
    /// draws with programs whose fragment shader has TRANSPARENT defined and ends in writeColour()
    /// (glsl/draw/output.glsl).
    void draw(const PictureTarget& target, const std::function<void()>& pass);

  private:
    void fit(const PictureTarget&);

    const gl::VertexArray& noAttributes_;
    gl::Program overlay_;
    GLuint depth_ = 0;  ///< the target's that the framebuffer was made for
    gl::Texture light_, transmission_;
    gl::Framebuffer framebuffer_;
};

}  // namespace sunder::render
