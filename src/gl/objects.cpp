#include "gl/objects.hpp"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string>

#include "core/memory.hpp"
#include "core/types.hpp"
#include "gl/device_failure.hpp"
#include "gl/driver.hpp"
#include "gl/error_name.hpp"
#include "gl/pixel_format.hpp"

namespace sunder::gl {

using namespace core;

namespace {

/// While it lives, Sunder's debug callback stays silent: the errors of one allocation become an
/// exception here instead. A host's hears of them.
class QuietDebug {
  public:
    QuietDebug()
        : wasOn_(Driver::current()->owner() == Driver::Owner::Sunder && functions().KHR_debug &&
                 glIsEnabled(GL_DEBUG_OUTPUT)) {
        if (wasOn_) glDisable(GL_DEBUG_OUTPUT);
    }
    ~QuietDebug() {
        if (wasOn_) glEnable(GL_DEBUG_OUTPUT);
    }
    QuietDebug(const QuietDebug&) = delete;
    QuietDebug& operator=(const QuietDebug&) = delete;

  private:
    bool wasOn_;
};

const std::string& renderer() {
    return Driver::current()->info().renderer;
}

std::string withSize(const char* what, double bytes) {
    const auto megabytes = static_cast<std::uint64_t>(bytes / 1e6 + 0.5);
    return std::string(what) + " (" + std::to_string(megabytes) + " MB)";
}

/// Bytes. Mesa's software driver has what this machine has, but takes any promise of the system's
/// for it. The other half is for the world and for states that come back from the device.
double softwareMemory() {
    static const double half = static_cast<double>(usableMemory()) / 2;
    return half;
}

/// Runs an allocation. Throws InputError when the device has no memory for it, DeviceError when it
/// is lost. `succeeded` tells, afterwards, where glGetError is not to be asked.
template <class Call, class Succeeded>
void allocate(const char* what, double bytes, Call call, Succeeded succeeded) {
    const bool asks = Driver::current()->asksErrors();
    if (const GLenum error = asks ? glGetError() : GL_NO_ERROR; error != GL_NO_ERROR) {
        throwIfFatal(error);
        throw std::runtime_error("OpenGL: " + errorName(error) + " before the " + what +
                                 " was created");
    }
    if (Driver::current()->info().software &&
        static_cast<double>(allocatedBytes()) + bytes > softwareMemory())
        failMemory(withSize(what, bytes));
    const QuietDebug quiet;
    call();
    if (!asks) {
        if (!succeeded()) failMemory(withSize(what, bytes));
        return;
    }
    const GLenum error = glGetError();
    if (error == GL_OUT_OF_MEMORY) failMemory(withSize(what, bytes));
    throwIfFatal(error);
    if (error != GL_NO_ERROR)
        throw std::runtime_error("OpenGL: " + errorName(error) + " creating the " + what);
}

}  // namespace

std::size_t allocatedBytes() {
    const Driver* driver = Driver::current();
    return driver ? driver->buffers.total() + driver->textures.total() : 0;
}

void deleteBuffer(GLuint id) {
    if (!Driver::current()) return;
    Driver::current()->buffers.remove(id);
    glDeleteBuffers(1, &id);
}
void deleteTexture(GLuint id) {
    if (!Driver::current()) return;
    Driver::current()->textures.remove(id);
    glDeleteTextures(1, &id);
}
void deleteFramebuffer(GLuint id) {
    if (Driver::current()) glDeleteFramebuffers(1, &id);
}
void deleteVertexArray(GLuint id) {
    if (Driver::current()) glDeleteVertexArrays(1, &id);
}
void deleteProgram(GLuint id) {
    if (!Driver::current()) return;
    // Where other objects are unbound, a program would stay in use, and who puts it back would
    // fail.
    if (boundName(GL_CURRENT_PROGRAM) == id) glUseProgram(0);
    glDeleteProgram(id);
}
void deleteTransformFeedback(GLuint id) {
    if (Driver::current()) glDeleteTransformFeedbacks(1, &id);
}
void deleteSampler(GLuint id) {
    if (Driver::current()) glDeleteSamplers(1, &id);
}

// The COPY targets: no draw state, nor an element array in a vertex array object, depends on them.
Buffer::Buffer(std::size_t bytes, const void* data, GLenum usage, const char* what)
    : bytes_(bytes) {
    if (bytes > static_cast<std::size_t>(PTRDIFF_MAX))
        failMemory(withSize(what, static_cast<double>(bytes)));
    GLuint id = 0;
    glGenBuffers(1, &id);
    handle_ = Handle<deleteBuffer>(id);
    glBindBuffer(GL_COPY_WRITE_BUFFER, id);
    allocate(
        what, static_cast<double>(bytes),
        [&] { glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes), data, usage); },
        [&] {
            GLint64 size = -1;
            glGetBufferParameteri64v(GL_COPY_WRITE_BUFFER, GL_BUFFER_SIZE, &size);
            return size == static_cast<GLint64>(bytes);
        });
    Driver::current()->buffers.add(id, bytes);
}

void Buffer::write(std::size_t offset, std::size_t bytes, const void* data) {
    assert(offset <= bytes_ && bytes <= bytes_ - offset);
    if (bytes == 0) return;
    glBindBuffer(GL_COPY_WRITE_BUFFER, id());
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset),
                    static_cast<GLsizeiptr>(bytes), data);
}

void Buffer::copy(const Buffer& from) {
    assert(from.bytes_ == bytes_);
    glBindBuffer(GL_COPY_READ_BUFFER, from.id());
    glBindBuffer(GL_COPY_WRITE_BUFFER, id());
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                        static_cast<GLsizeiptr>(bytes_));
}

void Buffer::read(std::size_t offset, std::size_t bytes, void* data) const {
    assert(offset <= bytes_ && bytes <= bytes_ - offset);
    if (bytes == 0) return;
    glBindBuffer(GL_COPY_READ_BUFFER, id());
    glGetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(offset),
                       static_cast<GLsizeiptr>(bytes), data);
}

Framebuffer makeFramebuffer() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return Framebuffer(id);
}

int limit(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

VertexArray makeVertexArray() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return VertexArray(id);
}

TransformFeedback makeTransformFeedback() {
    GLuint id = 0;
    glGenTransformFeedbacks(1, &id);
    return TransformFeedback(id);
}

Sampler makeSampler() {
    GLuint id = 0;
    glGenSamplers(1, &id);
    return Sampler(id);
}

Texture makeBufferTexture(const Buffer& buffer, GLenum format, const char* what) {
    const std::size_t texels = buffer.size() / pixelFormat(format).bytes;
    const int most = limit(GL_MAX_TEXTURE_BUFFER_SIZE);
    if (texels > static_cast<std::size_t>(most))
        throw InputError("the world is too large for this device: " + std::string(what) +
                         " needs " + std::to_string(texels) + " texels, " + renderer() + " takes " +
                         std::to_string(most));
    GLuint id = 0;
    glGenTextures(1, &id);
    Texture texture(id);
    bindForWork(GL_TEXTURE_BUFFER, texture);
    glTexBuffer(GL_TEXTURE_BUFFER, format, buffer.id());
    return texture;
}

namespace {

/// Storage of a texture of `target`, which `define` (called with it bound) lays out.
template <class Define>
Texture makeTexture(GLenum target, int width, int height, int layers, GLenum format,
                    const char* what, Define define) {
    const int most = limit(GL_MAX_TEXTURE_SIZE);
    if (width < 1 || height < 1 || width > most || height > most)
        throw InputError("the " + std::string(what) + " would be " + std::to_string(width) + " x " +
                         std::to_string(height) + " texels, " + renderer() + " takes 1 to " +
                         std::to_string(most) + " each way");
    const PixelFormat pixel = pixelFormat(format);
    GLuint id = 0;
    glGenTextures(1, &id);
    Texture texture(id);
    bindForWork(target, texture);
    const std::size_t bytes = std::size_t{pixel.bytes} * static_cast<std::size_t>(width) *
                              static_cast<std::size_t>(height) * static_cast<std::size_t>(layers);
    allocate(
        what, static_cast<double>(bytes), [&] { define(pixel); },
        [&] {
            GLint there = 0;
            glGetTexLevelParameteriv(target, 0, GL_TEXTURE_WIDTH, &there);
            return there == width;
        });
    Driver::current()->textures.add(id, bytes);
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

}  // namespace

Texture makeTexture2D(int width, int height, GLenum format, const char* what) {
    return makeTexture(GL_TEXTURE_2D, width, height, 1, format, what,
                       [&](const PixelFormat& pixel) {
                           glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height,
                                        0, pixel.format, pixel.type, nullptr);
                       });
}

Texture makeTextureArray(int width, int height, int layers, GLenum format, const char* what) {
    return makeTexture(GL_TEXTURE_2D_ARRAY, width, height, layers, format, what,
                       [&](const PixelFormat& pixel) {
                           glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(format), width,
                                        height, layers, 0, pixel.format, pixel.type, nullptr);
                       });
}

void bindTexture(int unit, GLenum target, const Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    Driver::current()->touched.texture(unit, target);
    glBindTexture(target, texture.id());
}

void bindForWork(GLenum target, const Texture& texture) {
    bindTexture(kWorkUnit, target, texture);
}

void beginCaptures(const TransformFeedback& object) {
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, object.id());
}

void endCaptures() {
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, Driver::current()->idleFeedback);
}

void bindImage(int unit, const Texture& texture) {
    Driver::current()->touched.image(unit);
    glBindImageTexture(static_cast<GLuint>(unit), texture.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY,
                       GL_RGBA32F);
}

void bindUniforms(int binding, const Buffer& buffer) {
    Driver::current()->touched.uniforms(binding);
    glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(binding), buffer.id());
}

}  // namespace sunder::gl
