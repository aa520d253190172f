#include "render/cell_paint.hpp"

#include "render/uniforms.hpp"

namespace sunder::render {

void CellPaint::bindSampler(const gl::Program& program) {
    program.bindSampler("cellColours", kPaintUnit);
}

void CellPaint::set(const CellColours* colours) {
    painted_ = colours && !colours->colours().empty();
    if (!painted_) return;
    const std::span<const glm::vec4> texels = colours->colours();
    if (buffer_.size() != texels.size_bytes()) {
        buffer_ = gl::makeBuffer(texels, GL_STREAM_DRAW, "cell colours");
        texture_ = gl::makeBufferTexture(buffer_, GL_RGBA32F, "cell colours");
    } else {
        buffer_.write(0, texels.size_bytes(), texels.data());
    }
}

void CellPaint::bind(const gl::Program& program) const {
    setUniform(program, "painted", painted_);
    if (painted_) gl::bindTexture(kPaintUnit, GL_TEXTURE_BUFFER, texture_);
}

}  // namespace sunder::render
