#include "gpu/texel_target.hpp"

#include <algorithm>

#include "core/types.hpp"
#include "gpu/feedback.hpp"

namespace sunder::gpu {

using namespace core;

namespace {

/// Outputs of one fragment that every driver has.
constexpr int kLayersAtOnce = 8;

}  // namespace

int texelColumns(std::int64_t count) {
    std::int64_t columns = 64;
    while (4 * columns * columns < count && columns < 16384) columns *= 2;
    return static_cast<int>(columns);
}

int texelRows(std::int64_t count, int columns, const char* what) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const std::int64_t rows = (count + columns - 1) / columns;
    if (rows > most)
        throw InputError("the world is too large for this device: " + std::string(what) +
                         " need a texture of " + std::to_string(rows) + " rows, it takes " +
                         std::to_string(most) + "; use fewer cells or another solver");
    return static_cast<int>(std::max<std::int64_t>(1, rows));
}

TexelTarget::TexelTarget(int count, int columns, int layers, const char* what)
    : columns_(columns),
      rows_(texelRows(count, columns, what)),
      texture_(gl::makeTextureArray(columns, rows_, layers, GL_RGBA32F, what)),
      noAttributes_(gl::makeVertexArray()) {
    for (int first = 0; first < layers; first += kLayersAtOnce) {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_.emplace_back(gl::makeFramebuffer()).id());
        std::vector<GLenum> attachments;
        for (int layer = first; layer < std::min(layers, first + kLayersAtOnce); ++layer) {
            attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(layer - first));
            glFramebufferTextureLayer(GL_FRAMEBUFFER, attachments.back(), texture_.id(), 0, layer);
        }
        glDrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw DeviceError(
                "the driver cannot draw into floating-point textures, which the GPU solvers "
                "need");
    }
}

gl::Program TexelTarget::program(const World& world, const char* fragment,
                                 gl::Defines defines) const {
    gl::Program program({.vertex = "gather/texels.vert",
                         .fragment = fragment,
                         .defines = withTurned(std::move(defines), world.anyTurned())});
    setConstants(program, world, columns_);
    program.use();
    glUniform2i(program.uniform("targetSize"), columns_, rows_);
    return program;
}

void TexelTarget::bind(int part) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[static_cast<std::size_t>(part)].id());
    glViewport(0, 0, columns_, rows_);
}

void TexelTarget::fill(const gl::Program& program, const TexelRanges& ranges, int part) const {
    if (ranges.rectangles() == 0) return;
    bind(part);
    gl::bindTexture(kRectangles, GL_TEXTURE_BUFFER, ranges.texture());
    program.use();
    glBindVertexArray(noAttributes_.id());
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, ranges.rectangles());
}

void TexelTarget::write(int layer, int first, std::span<const vec4> texels) {
    gl::bindForWork(GL_TEXTURE_2D_ARRAY, texture_);
    const vec4* from = texels.data();
    for (const auto& [x0, y0, x1, y1] :
         rectanglesOf({first, first + static_cast<int>(texels.size())}, columns_)) {
        glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, x0, y0, layer, x1 - x0, y1 - y0, 1, GL_RGBA,
                        GL_FLOAT, from);
        from += (x1 - x0) * (y1 - y0);
    }
}

std::vector<vec4> TexelTarget::read(int layer, TexelRange range) const {
    std::vector<vec4> texels(static_cast<std::size_t>(range.end - range.first));
    bindForReading(layer);
    vec4* to = texels.data();
    for (const auto& [x0, y0, x1, y1] : rectanglesOf(range, columns_)) {
        glReadPixels(x0, y0, x1 - x0, y1 - y0, GL_RGBA, GL_FLOAT, to);
        to += (x1 - x0) * (y1 - y0);
    }
    return texels;
}

void TexelTarget::copy(int layer, const gl::Buffer& buffer, std::size_t offset) const {
    bindForReading(layer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer.id());
    glReadPixels(0, 0, columns_, rows_, GL_RGBA, GL_FLOAT, reinterpret_cast<void*>(offset));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

void TexelTarget::bindForReading(int layer) const {
    const int part = layer / kLayersAtOnce;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[static_cast<std::size_t>(part)].id());
    glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(layer % kLayersAtOnce));
}

std::size_t TexelTarget::layerTexels() const {
    return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
}

}  // namespace sunder::gpu
