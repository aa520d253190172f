#pragma once
#include "gl/functions.hpp"

#include <cstddef>
#include <span>
#include <utility>

namespace sunder::gl {

/// A GL name that is deleted with its owner. Move-only; a moved-from handle is empty (id() == 0)
/// and may be assigned to.
template <void (*Delete)(GLuint)>
class Handle {
  public:
    Handle() = default;
    explicit Handle(GLuint id) : id_(id) {}
    ~Handle() { reset(); }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        if (this != &other) {
            reset();
            id_ = std::exchange(other.id_, 0);
        }
        return *this;
    }
    GLuint id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

  private:
    void reset() {
        if (id_) Delete(id_);
        id_ = 0;
    }
    GLuint id_ = 0;
};

// Where no context is current, these do nothing: it took its objects with it.
void deleteBuffer(GLuint);
void deleteTexture(GLuint);
void deleteFramebuffer(GLuint);
void deleteVertexArray(GLuint);
void deleteProgram(GLuint);
void deleteTransformFeedback(GLuint);
void deleteSampler(GLuint);

using Framebuffer = Handle<deleteFramebuffer>;
using VertexArray = Handle<deleteVertexArray>;
using Texture = Handle<deleteTexture>;
using Sampler = Handle<deleteSampler>;
/// Remembers how much was captured, so that it can be drawn without asking.
using TransformFeedback = Handle<deleteTransformFeedback>;

/// Bytes of the buffers and 2D textures made below that are alive in the current context: what
/// Sunder asked for, not what the driver rounds it to.
std::size_t allocatedBytes();

/// A buffer object of fixed size.
class Buffer {
  public:
    Buffer() = default;
    /// `data` may be null: contents undefined. Throws InputError, naming `what`, when the device
    /// has no memory for it.
    Buffer(std::size_t bytes, const void* data, GLenum usage, const char* what);
    GLuint id() const { return handle_.id(); }
    std::size_t size() const { return bytes_; }
    /// Within size(); offset and bytes count bytes.
    void write(std::size_t offset, std::size_t bytes, const void* data);
    /// All of `from`, which is of the same size, within the GPU.
    void copy(const Buffer& from);
    /// Waits for the GPU; never inside a frame.
    void read(std::size_t offset, std::size_t bytes, void* data) const;

  private:
    Handle<deleteBuffer> handle_;
    std::size_t bytes_ = 0;
};

template <class T>
Buffer makeBuffer(std::span<const T> data, GLenum usage, const char* what) {
    return Buffer(data.size_bytes(), data.data(), usage, what);
}

Framebuffer makeFramebuffer();
VertexArray makeVertexArray();
TransformFeedback makeTransformFeedback();
Sampler makeSampler();
/// A view of `buffer` as texels of `format` (GL_RGBA32F, …). Throws InputError, naming `what`, when
/// the device's GL_MAX_TEXTURE_BUFFER_SIZE is smaller. Leaves kWorkUnit active.
Texture makeBufferTexture(const Buffer& buffer, GLenum format, const char* what);
/// 2D texture, one level, nearest filtering, clamped, contents undefined. Throws InputError, naming
/// `what`, when a side is not within 1 to GL_MAX_TEXTURE_SIZE or the device has no memory for it.
/// Leaves kWorkUnit active.
Texture makeTexture2D(int width, int height, GLenum format, const char* what);
/// The same with `layers` layers (a 2D array texture).
Texture makeTextureArray(int width, int height, int layers, GLenum format, const char* what);

/// What the device allows at most, such as GL_MAX_TEXTURE_SIZE.
int limit(GLenum name);

/// The unit on which textures are made and written: no sampler reads it, so nothing that a pass has
/// bound is lost. GL 4.1 has 80.
inline constexpr int kWorkUnit = 63;

/// Binds a texture to a unit, which becomes the active one. Units are bound by this alone: during a
/// Visit it first takes note of what the host has there.
void bindTexture(int unit, GLenum target, const Texture&);
/// On kWorkUnit.
void bindForWork(GLenum target, const Texture&);
/// Captures go to that object, until endCaptures().
void beginCaptures(const TransformFeedback&);
void endCaptures();
/// All of a buffer becomes what uniform blocks with that binding read. Likewise, by this alone.
void bindUniforms(int binding, const Buffer&);
/// All layers of an RGBA32F array texture, for shaders that write them. Needs OpenGL 4.2.
void bindImage(int unit, const Texture&);

}  // namespace sunder::gl
