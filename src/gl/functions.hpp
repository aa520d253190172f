#pragma once
// OpenGL, as the context that is current on the calling thread has it: glFoo(...) calls that
// context's own function. Include this, never <glad/gl.h> alone. Two contexts may have different
// functions for the same name (on Windows they do when their pixel formats differ, everywhere when
// two drivers made them), and two threads have different contexts: nothing here belongs to the
// process.
#include <glad/gl.h>

#include <cassert>

namespace sunder::gl {

/// A function for every name of GL 4.1, and a flag for every extension in
/// third_party/dependencies.cmake: `functions().KHR_debug`.
using Functions = GladGLContext;

namespace detail {
/// Set by Driver::makeCurrent() and by Visit, nobody else.
extern constinit thread_local Functions* currentFunctions;
}  // namespace detail

/// Of the context that is current on this thread. There must be one: a Context, or a Visit to a
/// host's.
inline Functions& functions() {
    assert(detail::currentFunctions && "GL is called where no context is current");
    return *detail::currentFunctions;
}

}  // namespace sunder::gl

#include <glad/calls.h>

namespace sunder::gl {

/// The name of what is bound, such as GL_ARRAY_BUFFER_BINDING asks for; 0: nothing.
inline GLuint boundName(GLenum binding) {
    GLint name = 0;
    glGetIntegerv(binding, &name);
    return static_cast<GLuint>(name);
}

}  // namespace sunder::gl
