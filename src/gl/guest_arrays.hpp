#pragma once
#include <array>
#include <vector>

#include "gl/driver.hpp"

namespace sunder::gl {

// State that is one of several, or takes several numbers at once, and so is in no table.

/// Blending and colour masks of every draw buffer. Sunder's passes depend on them and set them.
class Blending {
  public:
    void save(Driver&);
    void neutralise(Driver&);
    void neutraliseAll(Driver&);
    void restore(Driver&);

  private:
    struct Buffer {
        GLboolean on = GL_FALSE, mask[4] = {GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE};
        GLint equations[2] = {GL_FUNC_ADD, GL_FUNC_ADD};        ///< colour, alpha
        GLint factors[4] = {GL_ONE, GL_ZERO, GL_ONE, GL_ZERO};  ///< source, destination; of alpha
        bool operator==(const Buffer&) const = default;
    };
    static void setAll(const Buffer&);
    static void set(GLuint index, const Buffer&);

    std::vector<Buffer> before_;
    bool alike_ = true;  ///< all of them
};

/// glViewport sets every viewport, and glDisable every viewport's scissor. Of the rest only the
/// first viewport's matters, as no shader of Sunder's chooses another.
class Viewports {
  public:
    void save(Driver&);
    void neutralise(Driver&);
    void neutraliseAll(Driver&);
    void restore(Driver&);

  private:
    std::vector<std::array<GLfloat, 4>> rectangles_;
    std::vector<GLboolean> scissors_;
    GLdouble depths_[2] = {};
    GLboolean exclusive_ = GL_FALSE;  ///< GL_NV_scissor_exclusive
    GLint swizzle_[4] = {};           ///< GL_NV_viewport_swizzle
};

/// Sunder's renderer sets it.
class PolygonOffset {
  public:
    void save(Driver&);
    void neutralise(Driver&) {}
    void neutraliseAll(Driver&) {}
    void restore(Driver&);

  private:
    GLfloat factor_ = 0, units_ = 0, clamp_ = 0;
};

/// GL 4.5: which way up a viewport is, and the range of depth. Passes depend on it.
class ClipControl {
  public:
    void save(Driver&);
    void neutralise(Driver&);
    void neutraliseAll(Driver&);
    void restore(Driver&);

  private:
    GLint origin_ = GL_LOWER_LEFT, depth_ = GL_NEGATIVE_ONE_TO_ONE;
};

/// GL_EXT_window_rectangles: more scissors, for framebuffer objects alone.
class WindowRectangles {
  public:
    void save(Driver&);
    void neutralise(Driver&);
    void neutraliseAll(Driver&);
    void restore(Driver&);

  private:
    GLint mode_ = GL_EXCLUSIVE_EXT;
    std::vector<GLint> boxes_;
};

}  // namespace sunder::gl
