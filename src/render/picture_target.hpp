#pragma once
#include <glm/glm.hpp>

#include "gl/objects.hpp"
#include "image/image.hpp"

namespace sunder::render {

/// A texture to draw into: of so many samples (GL_TEXTURE_2D_MULTISAMPLE), or plain (GL_TEXTURE_2D)
/// for one, as drivers round a multisample texture's one up. Throws InputError when the device has
/// no room for it.
gl::Texture makeSamples(int width, int height, int samples, GLenum format);
/// Throws InputError when the device cannot draw to the bound framebuffer, of that size.
void requireComplete(int width, int height);

/// Where a picture is drawn off screen: a multisampled sRGB framebuffer and a plain one that it is
/// resolved to.
class PictureTarget {
  public:
    PictureTarget() = default;
    /// `samples` is clamped to what the device has. Throws InputError when the device has no room
    /// for the picture.
    PictureTarget(int width, int height, int samples);

    bool fits(int width, int height, int samples) const {
        return width == width_ && height == height_ && samples == samples_;
    }
    int width() const { return width_; }
    int height() const { return height_; }
    /// What the device has of the samples asked for.
    int sampleCount() const { return sampleCount_; }
    /// Of its textures.
    GLenum textureTarget() const {
        return sampleCount_ > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    }
    const gl::Texture& depth() const { return depth_; }

    /// Binds the multisampled framebuffer, cleared to a linear colour, and its viewport.
    void begin(const glm::vec3& background) const;
    /// Binds it as it is.
    void bind() const;
    /// Averages the samples; the plain framebuffer is bound afterwards.
    void resolve() const;
    /// Copies the resolved picture into the default framebuffer, which is bound afterwards, its
    /// lower left corner at these pixels.
    void show(int left, int bottom) const;
    /// Reads the resolved picture. Waits for the GPU.
    image::Image read() const;

  private:
    int width_ = 0, height_ = 0, samples_ = 0, sampleCount_ = 0;
    gl::Texture colour_, depth_, resolved_;
    gl::Framebuffer drawn_, plain_;
};

}  // namespace sunder::render
