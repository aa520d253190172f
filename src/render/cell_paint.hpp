#pragma once
#include "gl/program.hpp"
#include "render/cell_colours.hpp"

namespace sunder::render {

/// CellColours on the GPU, for every program that includes draw/paint.glsl.
class CellPaint {
  public:
    /// Once, when such a program is made: which texture unit it reads. Uses the program.
    static void bindSampler(const gl::Program&);

    /// What is drawn from now on; null: the materials' own colours.
    void set(const CellColours*);
    /// Sets what draw/paint.glsl reads, for the program in use.
    void bind(const gl::Program&) const;

  private:
    bool painted_ = false;
    gl::Buffer buffer_;  ///< none until it is needed
    gl::Texture texture_;
};

}  // namespace sunder::render
