#include "gl/driver.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "core/types.hpp"
#include "gl/device_failure.hpp"
#include "gl/error_name.hpp"
#include "gl/objects.hpp"

namespace sunder::gl {

using namespace core;

namespace detail {
constinit thread_local Functions* currentFunctions = nullptr;
}  // namespace detail

namespace {

constinit thread_local Driver* currentDriver = nullptr;

// A broken draw reports the same error every frame.
constexpr std::size_t kMaxCollected = 100;

std::string text(GLenum name) {
    const GLubyte* value = glGetString(name);
    return value ? reinterpret_cast<const char*>(value) : "";
}

GLADapiproc loadThrough(void* load, const char* name) {
    return (*static_cast<const Driver::LoadFunction*>(load))(name);
}

/// Current for as long as it lives.
class Current {
  public:
    explicit Current(Driver& driver) : before_(Driver::current()) { driver.makeCurrent(); }
    ~Current() { Driver::setCurrent(before_); }
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

  private:
    Driver* before_;
};

}  // namespace

bool isSoftware(const std::string& renderer) {
    const char* const names[] = {
        "llvmpipe", "softpipe", "swrast", "SwiftShader", "Software Rasterizer", "GDI Generic"};
    return std::any_of(std::begin(names), std::end(names),
                       [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

Driver::Driver(const LoadFunction& load, std::string device, Owner owner)
    : owner_(owner), asks_(owner == Owner::Sunder) {
    LoadFunction function = load;
    const int loaded = gladLoadGLContextUserPtr(&functions_, loadThrough, &function);
    if (loaded == 0) throw DeviceError("the driver's OpenGL entry points do not load");
    const Current current(*this);
    const int major = GLAD_VERSION_MAJOR(loaded), minor = GLAD_VERSION_MINOR(loaded);
    // OpenGL ES counts its versions for itself.
    const bool embedded = text(GL_VERSION).starts_with("OpenGL ES");
    if (embedded || major < 4 || (major == 4 && minor < 1))
        throw DeviceError("the driver offers OpenGL " + std::string(embedded ? "ES " : "") +
                          std::to_string(major) + "." + std::to_string(minor) +
                          ", Sunder needs 4.1 (" + text(GL_RENDERER) + ")");
    info_.device = std::move(device);
    learn();
    if (info_.compatibility)
        pixelTransfer_ = reinterpret_cast<decltype(pixelTransfer_)>(load("glPixelTransferf"));
    if (owner == Owner::Sunder) listen();
}

Driver::~Driver() {
    if (current() == this) setCurrent(nullptr);
}

Driver* Driver::current() {
    return currentDriver;
}

void Driver::makeCurrent() {
    setCurrent(this);
}

void Driver::setCurrent(Driver* driver) {
    currentDriver = driver;
    detail::currentFunctions = driver ? &driver->functions_ : nullptr;
}

void Driver::learn() {
    info_.vendor = text(GL_VENDOR);
    info_.renderer = text(GL_RENDERER);
    info_.version = text(GL_VERSION);
    info_.glslVersion = text(GL_SHADING_LANGUAGE_VERSION);
    info_.software = isSoftware(info_.renderer);
    info_.compatibility =
        (limit(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0;
    info_.maxTextureSize = limit(GL_MAX_TEXTURE_SIZE);
    info_.maxTextureBufferSize = limit(GL_MAX_TEXTURE_BUFFER_SIZE);
    info_.maxUniformBlockSize = limit(GL_MAX_UNIFORM_BLOCK_SIZE);
    info_.maxTransformFeedbackComponents = limit(GL_MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS);
    info_.maxGeometryOutputComponents = limit(GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS);
    info_.maxSamples = limit(GL_MAX_SAMPLES);
    info_.maxDrawBuffers = limit(GL_MAX_DRAW_BUFFERS);
    info_.maxViewports = limit(GL_MAX_VIEWPORTS);
}

void Driver::listen() {
    if (!functions_.KHR_debug) return;
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
            auto* self = const_cast<Driver*>(static_cast<const Driver*>(user));
            self->collect(message, type == GL_DEBUG_TYPE_ERROR);
        },
        this);
}

void Driver::collect(const char* message, bool isError) {
    errorReported_ |= isError;
    if (errors_.size() < kMaxCollected) errors_.emplace_back(message);
}

void Driver::drain() {
    // glGetError may answer for ever once a context is lost.
    for (int i = 0; i < 8 && !lost_; ++i) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR) break;
        lost_ |= error == GL_CONTEXT_LOST;
        exhausted_ |= error == GL_OUT_OF_MEMORY;
        if (!errorReported_ && errors_.size() < kMaxCollected) errors_.push_back(errorName(error));
    }
}

void Driver::noteErrorsBefore() {
    if (owner_ == Owner::Sunder) return drain();
    for (int i = 0; i < 8; ++i) {
        const GLenum error = glGetError();
        if (error == GL_NO_ERROR) break;
        if (hostErrors_.size() < kMaxCollected) hostErrors_.push_back(errorName(error));
    }
}

std::vector<std::string> Driver::takeErrors() {
    const Current current(*this);
    lost_ |= contextLost();
    if (asks_) drain();
    if (lost_) failContextLost();
    errorReported_ = false;
    return std::exchange(errors_, {});
}

void Driver::check() {
    const std::vector<std::string> errors = takeErrors();
    if (std::exchange(exhausted_, false)) failMemory();
    if (!errors.empty()) throw std::runtime_error("OpenGL: " + errors.front());
}

const ShaderSource& currentShaders() {
    static const ShaderSource embedded = embeddedShaders();
    const Driver* driver = Driver::current();
    return driver ? driver->shaders : embedded;
}

void useShaders(ShaderSource source) {
    assert(Driver::current());
    Driver::current()->shaders = std::move(source);
}

}  // namespace sunder::gl
