#include "render/picture_target.hpp"

#include <algorithm>
#include <string>

#include "core/types.hpp"
#include "gl/device_failure.hpp"

namespace sunder::render {

using namespace core;

namespace {

[[noreturn]] void failSize(int width, int height) {
    if (gl::contextLost()) gl::failContextLost();
    throw InputError("the device cannot draw a picture of " + std::to_string(width) + " x " +
                     std::to_string(height) + " pixels; a smaller --size may work");
}

int limit(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

}  // namespace

void requireComplete(int width, int height) {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        failSize(width, height);
}

gl::Texture makeSamples(int width, int height, int samples, GLenum format) {
    if (samples == 1) return gl::makeTexture2D(width, height, format, "picture");
    GLuint id = 0;
    glGenTextures(1, &id);
    gl::Texture texture(id);
    gl::bindForWork(GL_TEXTURE_2D_MULTISAMPLE, texture);
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, format, width, height, GL_TRUE);
    if (glGetError() == GL_OUT_OF_MEMORY) failSize(width, height);
    return texture;
}

PictureTarget::PictureTarget(int width, int height, int samples)
    : width_(width), height_(height), samples_(samples) {
    const int largest = limit(GL_MAX_TEXTURE_SIZE);
    if (width < 1 || height < 1 || width > largest || height > largest ||
        std::int64_t{width} * height > image::kMaxPixels)
        throw InputError("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                         " pixels cannot be drawn; each side must be 1 to " +
                         std::to_string(largest) + " and their product at most " +
                         std::to_string(image::kMaxPixels));
    const int most =
        std::min(limit(GL_MAX_COLOR_TEXTURE_SAMPLES), limit(GL_MAX_DEPTH_TEXTURE_SAMPLES));
    sampleCount_ = std::clamp(samples, 1, std::max(most, 1));

    colour_ = makeSamples(width, height, sampleCount_, GL_SRGB8_ALPHA8);
    depth_ = makeSamples(width, height, sampleCount_, GL_DEPTH_COMPONENT32F);
    drawn_ = gl::makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, textureTarget(), colour_.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, textureTarget(), depth_.id(), 0);
    requireComplete(width, height);

    resolved_ = gl::makeTexture2D(width, height, GL_SRGB8_ALPHA8, "picture");
    plain_ = gl::makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, plain_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, resolved_.id(), 0);
    requireComplete(width, height);
}

void PictureTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_.id());
}

void PictureTarget::begin(const glm::vec3& background) const {
    bind();
    glViewport(0, 0, width_, height_);
    glClearColor(background.r, background.g, background.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void PictureTarget::resolve() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, plain_.id());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, plain_.id());
}

void PictureTarget::show(int left, int bottom) const {
    // Without the conversion that GL_FRAMEBUFFER_SRGB asks for, bytes are copied as they are: a
    // window takes them for sRGB, which they are.
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, plain_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width_, height_, left, bottom, left + width_, bottom + height_,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

image::Image PictureTarget::read() const {
    glBindFramebuffer(GL_FRAMEBUFFER, plain_.id());
    // Four channels: drivers convert to three slowly.
    std::vector<std::uint8_t> rgba(std::size_t{4} * width_ * height_);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());

    image::Image image{width_, height_, {}};
    image.pixels.resize(std::size_t{3} * width_ * height_);
    auto out = image.pixels.begin();
    for (int row = height_ - 1; row >= 0; --row) {  // GL's rows run upwards
        const std::uint8_t* in = rgba.data() + std::size_t{4} * width_ * row;
        for (int column = 0; column < width_; ++column, in += 4) out = std::copy_n(in, 3, out);
    }
    return image;
}

}  // namespace sunder::render
