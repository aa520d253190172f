#include "gl/context.hpp"

#include <glad/gl.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "gl/device_failure.hpp"
#include "gl/error_name.hpp"
#include "gl/objects.hpp"

namespace sunder::gl {

using namespace core;

namespace {

// A broken draw reports the same error every frame.
constexpr std::size_t kMaxCollected = 100;

std::string text(GLenum name) {
    const GLubyte* value = glGetString(name);
    return value ? reinterpret_cast<const char*>(value) : "";
}

}  // namespace

bool isSoftware(const std::string& renderer) {
    const char* const names[] = {
        "llvmpipe", "softpipe", "swrast", "SwiftShader", "Software Rasterizer", "GDI Generic"};
    return std::any_of(std::begin(names), std::end(names),
                       [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

Context::~Context() = default;

void Context::initialise(LoadFunction load, std::string device) {
    const int loaded = gladLoadGL(load);
    if (loaded == 0) throw ContextError("the driver's OpenGL entry points do not load");
    const int major = GLAD_VERSION_MAJOR(loaded), minor = GLAD_VERSION_MINOR(loaded);
    if (major < 4 || (major == 4 && minor < 1))
        throw ContextError("the driver offers OpenGL " + std::to_string(major) + "." +
                           std::to_string(minor) + ", Sunder needs 4.1 (" + text(GL_RENDERER) +
                           ")");

    info_.vendor = text(GL_VENDOR);
    info_.renderer = text(GL_RENDERER);
    info_.version = text(GL_VERSION);
    info_.glslVersion = text(GL_SHADING_LANGUAGE_VERSION);
    info_.device = std::move(device);
    info_.software = isSoftware(info_.renderer);
    info_.maxTextureSize = limit(GL_MAX_TEXTURE_SIZE);
    info_.maxTextureBufferSize = limit(GL_MAX_TEXTURE_BUFFER_SIZE);
    info_.maxUniformBlockSize = limit(GL_MAX_UNIFORM_BLOCK_SIZE);
    info_.maxTransformFeedbackComponents = limit(GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS);
    info_.maxGeometryOutputComponents = limit(GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS);
    info_.maxSamples = limit(GL_MAX_SAMPLES);

    if (!GLAD_GL_KHR_debug) return;
    glEnable(GL_DEBUG_OUTPUT);
    // The callback then runs inside the call that failed: a breakpoint in it shows the culprit.
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr,
                          GL_FALSE);
    glDebugMessageCallback(
        [](GLenum source, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* message,
           const void* user) {
            // Program throws the compiler's log itself.
            if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
            if (type == GL_DEBUG_TYPE_PERFORMANCE) return;
            if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
            auto* self = const_cast<Context*>(static_cast<const Context*>(user));
            self->collect(message, type == GL_DEBUG_TYPE_ERROR);
        },
        this);
}

void Context::collect(const char* message, bool isError) {
    errorReported_ |= isError;
    if (errors_.size() < kMaxCollected) errors_.emplace_back(message);
}

std::vector<std::string> Context::takeErrors() {
    lost_ |= contextLost();
    // glGetError may answer for ever once a context is lost.
    for (int i = 0; i < 8 && !lost_; ++i) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR) break;
        lost_ |= error == GL_CONTEXT_LOST;
        exhausted_ |= error == GL_OUT_OF_MEMORY;
        if (!errorReported_) errors_.push_back(errorName(error));
    }
    if (lost_) failContextLost();
    errorReported_ = false;
    return std::exchange(errors_, {});
}

void Context::check() {
    const std::vector<std::string> errors = takeErrors();
    if (std::exchange(exhausted_, false)) failMemory();
    if (!errors.empty()) throw std::runtime_error("OpenGL: " + errors.front());
}

}  // namespace sunder::gl
