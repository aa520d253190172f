#include "gl/objects.hpp"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>

#include "core/memory.hpp"
#include "core/types.hpp"
#include "gl/context.hpp"
#include "gl/device_failure.hpp"
#include "gl/error_name.hpp"
#include "gl/pixel_format.hpp"

namespace sunder::gl {

using namespace core;

namespace {

/// While it lives, the debug callback stays silent: the errors of one allocation become an
/// exception here instead.
class QuietDebug {
  public:
    QuietDebug() : wasOn_(GLAD_GL_KHR_debug && glIsEnabled(GL_DEBUG_OUTPUT)) {
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

std::string renderer() {
    const GLubyte* name = glGetString(GL_RENDERER);
    return name ? reinterpret_cast<const char*>(name) : "this device";
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

/// Runs an allocation. Throws InputError when the device has no memory for it, ContextError when it
/// is lost.
template <class Call>
void allocate(const char* what, double bytes, Call call) {
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        throwIfFatal(error);
        throw std::runtime_error("OpenGL: " + errorName(error) + " before the " + what +
                                 " was created");
    }
    if (isSoftware(renderer()) && static_cast<double>(allocatedBytes()) + bytes > softwareMemory())
        failMemory(withSize(what, bytes));
    const QuietDebug quiet;
    call();
    const GLenum error = glGetError();
    if (error == GL_OUT_OF_MEMORY) failMemory(withSize(what, bytes));
    throwIfFatal(error);
    if (error != GL_NO_ERROR)
        throw std::runtime_error("OpenGL: " + errorName(error) + " creating the " + what);
}

/// Sizes of what is alive, by name. Contexts live one at a time and outlive their objects, so names
/// are unique.
class Allocations {
  public:
    void add(GLuint id, std::size_t bytes) {
        remove(id);
        sizes_[id] = bytes;
        total_ += bytes;
    }
    void remove(GLuint id) {
        const auto found = sizes_.find(id);
        if (found == sizes_.end()) return;
        total_ -= found->second;
        sizes_.erase(found);
    }
    std::size_t total() const { return total_; }

  private:
    std::unordered_map<GLuint, std::size_t> sizes_;
    std::size_t total_ = 0;
};

Allocations& bufferAllocations() {
    static Allocations allocations;
    return allocations;
}
Allocations& textureAllocations() {
    static Allocations allocations;
    return allocations;
}

}  // namespace

std::size_t allocatedBytes() {
    return bufferAllocations().total() + textureAllocations().total();
}

void deleteBuffer(GLuint id) {
    bufferAllocations().remove(id);
    glDeleteBuffers(1, &id);
}
void deleteTexture(GLuint id) {
    textureAllocations().remove(id);
    glDeleteTextures(1, &id);
}
void deleteFramebuffer(GLuint id) {
    glDeleteFramebuffers(1, &id);
}
void deleteVertexArray(GLuint id) {
    glDeleteVertexArrays(1, &id);
}
void deleteProgram(GLuint id) {
    glDeleteProgram(id);
}
void deleteTransformFeedback(GLuint id) {
    glDeleteTransformFeedbacks(1, &id);
}
void deleteSampler(GLuint id) {
    glDeleteSamplers(1, &id);
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
    allocate(what, static_cast<double>(bytes), [&] {
        glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes), data, usage);
    });
    bufferAllocations().add(id, bytes);
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
    glBindTexture(GL_TEXTURE_BUFFER, id);
    glTexBuffer(GL_TEXTURE_BUFFER, format, buffer.id());
    glBindTexture(GL_TEXTURE_BUFFER, 0);
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
    glBindTexture(target, id);
    const std::size_t bytes = std::size_t{pixel.bytes} * static_cast<std::size_t>(width) *
                              static_cast<std::size_t>(height) * static_cast<std::size_t>(layers);
    allocate(what, static_cast<double>(bytes), [&] { define(pixel); });
    textureAllocations().add(id, bytes);
    glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(target, 0);
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
    glBindTexture(target, texture.id());
}

}  // namespace sunder::gl
