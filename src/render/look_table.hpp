#pragma once
#include "core/world.hpp"
#include "gl/program.hpp"

namespace sunder::render {

/// What every material looks like (SurfaceLook in glsl/shared/layout.h): a row for each row of the
/// world's table of laws.
class LookTable {
  public:
    explicit LookTable(const core::World&);

    /// Once for a program that includes draw/looks.glsl.
    static void prepare(const gl::Program&);
    /// Before drawing with such programs.
    void bind() const;
    /// Whether a material lets light through: it is drawn after the others.
    bool anyTransparent() const { return anyTransparent_; }

  private:
    gl::Buffer buffer_;
    bool anyTransparent_;
};

}  // namespace sunder::render
