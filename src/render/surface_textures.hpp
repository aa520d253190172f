#pragma once
#include "core/world.hpp"
#include "gl/program.hpp"

namespace sunder {

/// Wood grain, brick, mortar, concrete, rubber and the sky's clouds, made by fragment shaders: a 2D
/// array texture with mipmaps that tiles (glsl/draw/surface_layers.glsl has its texels). Only
/// layers that the world needs are made.
class SurfaceTextures {
  public:
    SurfaceTextures(const World&, const gl::VertexArray& noAttributes);

    /// Once for a program that samples `surfaces`.
    static void prepare(const gl::Program&);
    /// Before drawing with such programs.
    void bind() const;

  private:
    gl::Texture layers_;
};

}  // namespace sunder
