#pragma once
#include <array>
#include <set>

#include "../../glsl/draw/surface_layers.h"
#include "core/world.hpp"
#include "gl/program.hpp"

namespace sunder::render {

/// Wood grain, brick, mortar, concrete, rubber and the sky's clouds, made by fragment shaders: a 2D
/// array texture with mipmaps that tiles (glsl/draw/surface_layers.glsl has its texels). Only
/// layers that the world needs are made.
class SurfaceTextures {
  public:
    SurfaceTextures(const core::World&, const gl::VertexArray& noAttributes);
    /// Whether it has just the layers that a world needs.
    bool fits(const core::World&) const;

    /// Once for a program that samples `surfaces`.
    static void prepare(const gl::Program&);
    /// For the program in use, before it draws.
    void bind(const gl::Program&) const;

  private:
    std::set<int> made_;
    std::array<int, SUNDER_SURFACE_LAYERS> places_{};  ///< of the layers, in the array
    gl::Texture layers_;
};

}  // namespace sunder::render
