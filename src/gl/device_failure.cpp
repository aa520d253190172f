#include "gl/device_failure.hpp"

#include <string>

#include "core/types.hpp"

namespace sunder::gl {

using namespace core;

bool contextLost() {
    if (functions().KHR_robustness) return glGetGraphicsResetStatus() != GL_NO_ERROR;
    if (functions().ARB_robustness) return glGetGraphicsResetStatusARB() != GL_NO_ERROR;
    return false;
}

void failContextLost() {
    // A lost context may not even know its name.
    const GLubyte* renderer = glGetString(GL_RENDERER);
    throw DeviceError("the OpenGL context was lost: the device or its driver was reset" +
                      (renderer ? " (" + std::string(reinterpret_cast<const char*>(renderer)) + ")"
                                : std::string()) +
                      "; run it again, with fewer cells if that does not help");
}

void failMemory(const std::string& what) {
    throw MemoryError("the device has no memory " + (what.empty() ? "left" : "for the " + what) +
                      "; use fewer cells, smaller pictures or the solver cpu");
}

void throwIfFatal(GLenum error) {
    if (error == GL_CONTEXT_LOST) failContextLost();
    if (error == GL_OUT_OF_MEMORY) failMemory();
}

}  // namespace sunder::gl
