#include "gl/guest_arrays.hpp"

#include <algorithm>
#include <iterator>

namespace sunder::gl {
namespace {

GLenum toEnum(GLint value) {
    return static_cast<GLenum>(value);
}

constexpr GLenum kSwizzles[] = {GL_VIEWPORT_SWIZZLE_X_NV, GL_VIEWPORT_SWIZZLE_Y_NV,
                                GL_VIEWPORT_SWIZZLE_Z_NV, GL_VIEWPORT_SWIZZLE_W_NV};
constexpr GLint kPlain[] = {GL_VIEWPORT_SWIZZLE_POSITIVE_X_NV, GL_VIEWPORT_SWIZZLE_POSITIVE_Y_NV,
                            GL_VIEWPORT_SWIZZLE_POSITIVE_Z_NV, GL_VIEWPORT_SWIZZLE_POSITIVE_W_NV};

void swizzle(const GLint* axes) {
    glViewportSwizzleNV(0, toEnum(axes[0]), toEnum(axes[1]), toEnum(axes[2]), toEnum(axes[3]));
}

}  // namespace

void Blending::save(Driver& driver) {
    before_.assign(static_cast<std::size_t>(driver.info().maxDrawBuffers), Buffer{});
    GLuint index = 0;
    for (Buffer& buffer : before_) {
        buffer.on = glIsEnabledi(GL_BLEND, index);
        glGetBooleani_v(GL_COLOR_WRITEMASK, index, buffer.mask);
        glGetIntegeri_v(GL_BLEND_EQUATION_RGB, index, &buffer.equations[0]);
        glGetIntegeri_v(GL_BLEND_EQUATION_ALPHA, index, &buffer.equations[1]);
        glGetIntegeri_v(GL_BLEND_SRC_RGB, index, &buffer.factors[0]);
        glGetIntegeri_v(GL_BLEND_DST_RGB, index, &buffer.factors[1]);
        glGetIntegeri_v(GL_BLEND_SRC_ALPHA, index, &buffer.factors[2]);
        glGetIntegeri_v(GL_BLEND_DST_ALPHA, index, &buffer.factors[3]);
        ++index;
    }
    alike_ = std::all_of(before_.begin(), before_.end(),
                         [&](const Buffer& buffer) { return buffer == before_[0]; });
}

void Blending::neutralise(Driver& driver) {
    if (!alike_ || before_[0] != Buffer{}) neutraliseAll(driver);
}

void Blending::neutraliseAll(Driver&) {
    setAll(Buffer{});
}

void Blending::restore(Driver&) {
    if (alike_) return setAll(before_[0]);
    GLuint index = 0;
    for (const Buffer& buffer : before_) set(index++, buffer);
}

void Blending::setAll(const Buffer& buffer) {
    if (buffer.on)
        glEnable(GL_BLEND);
    else
        glDisable(GL_BLEND);
    glColorMask(buffer.mask[0], buffer.mask[1], buffer.mask[2], buffer.mask[3]);
    // GL_KHR_blend_equation_advanced's cannot be set separately.
    if (buffer.equations[0] == buffer.equations[1])
        glBlendEquation(toEnum(buffer.equations[0]));
    else
        glBlendEquationSeparate(toEnum(buffer.equations[0]), toEnum(buffer.equations[1]));
    glBlendFuncSeparate(toEnum(buffer.factors[0]), toEnum(buffer.factors[1]),
                        toEnum(buffer.factors[2]), toEnum(buffer.factors[3]));
}

void Blending::set(GLuint index, const Buffer& buffer) {
    if (buffer.on)
        glEnablei(GL_BLEND, index);
    else
        glDisablei(GL_BLEND, index);
    glColorMaski(index, buffer.mask[0], buffer.mask[1], buffer.mask[2], buffer.mask[3]);
    if (buffer.equations[0] == buffer.equations[1])
        glBlendEquationi(index, toEnum(buffer.equations[0]));
    else
        glBlendEquationSeparatei(index, toEnum(buffer.equations[0]), toEnum(buffer.equations[1]));
    glBlendFuncSeparatei(index, toEnum(buffer.factors[0]), toEnum(buffer.factors[1]),
                         toEnum(buffer.factors[2]), toEnum(buffer.factors[3]));
}

void Viewports::save(Driver& driver) {
    const auto count = static_cast<std::size_t>(driver.info().maxViewports);
    rectangles_.resize(count);
    scissors_.resize(count);
    for (GLuint index = 0; index < count; ++index) {
        glGetFloati_v(GL_VIEWPORT, index, rectangles_[index].data());
        scissors_[index] = glIsEnabledi(GL_SCISSOR_TEST, index);
    }
    // NVIDIA's glGetDoublev rounds it to single precision.
    glGetDoublei_v(GL_DEPTH_RANGE, 0, depths_);
    if (driver.functions().NV_scissor_exclusive)
        exclusive_ = glIsEnabledi(GL_SCISSOR_TEST_EXCLUSIVE_NV, 0);
    if (driver.functions().NV_viewport_swizzle)
        for (int axis = 0; axis < 4; ++axis) glGetIntegeri_v(kSwizzles[axis], 0, &swizzle_[axis]);
}

void Viewports::neutralise(Driver& driver) {
    neutraliseAll(driver);
}

void Viewports::neutraliseAll(Driver& driver) {
    glDisable(GL_SCISSOR_TEST);
    glDepthRangeIndexed(0, 0, 1);
    if (driver.functions().NV_scissor_exclusive) glDisablei(GL_SCISSOR_TEST_EXCLUSIVE_NV, 0);
    if (driver.functions().NV_viewport_swizzle) swizzle(kPlain);
}

void Viewports::restore(Driver& driver) {
    glViewportArrayv(0, static_cast<GLsizei>(rectangles_.size()), rectangles_[0].data());
    for (GLuint index = 0; index < scissors_.size(); ++index)
        if (scissors_[index]) glEnablei(GL_SCISSOR_TEST, index);
    glDepthRangeIndexed(0, depths_[0], depths_[1]);
    if (exclusive_) glEnablei(GL_SCISSOR_TEST_EXCLUSIVE_NV, 0);
    if (driver.functions().NV_viewport_swizzle) swizzle(swizzle_);
}

void PolygonOffset::save(Driver& driver) {
    glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &factor_);
    glGetFloatv(GL_POLYGON_OFFSET_UNITS, &units_);
    if (driver.functions().ARB_polygon_offset_clamp) glGetFloatv(GL_POLYGON_OFFSET_CLAMP, &clamp_);
}

void PolygonOffset::restore(Driver& driver) {
    // The older function sets the clamp, too: to 0.
    if (driver.functions().ARB_polygon_offset_clamp)
        glPolygonOffsetClamp(factor_, units_, clamp_);
    else
        glPolygonOffset(factor_, units_);
}

void ClipControl::save(Driver& driver) {
    if (!driver.functions().ARB_clip_control) return;
    glGetIntegerv(GL_CLIP_ORIGIN, &origin_);
    glGetIntegerv(GL_CLIP_DEPTH_MODE, &depth_);
}

void ClipControl::neutralise(Driver& driver) {
    if (origin_ != GL_LOWER_LEFT || depth_ != GL_NEGATIVE_ONE_TO_ONE) neutraliseAll(driver);
}

void ClipControl::neutraliseAll(Driver& driver) {
    if (driver.functions().ARB_clip_control) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

void ClipControl::restore(Driver&) {
    if (origin_ != GL_LOWER_LEFT || depth_ != GL_NEGATIVE_ONE_TO_ONE)
        glClipControl(toEnum(origin_), toEnum(depth_));
}

void WindowRectangles::save(Driver& driver) {
    if (!driver.functions().EXT_window_rectangles) return;
    GLint count = 0;
    glGetIntegerv(GL_WINDOW_RECTANGLE_MODE_EXT, &mode_);
    glGetIntegerv(GL_NUM_WINDOW_RECTANGLES_EXT, &count);
    boxes_.resize(4 * static_cast<std::size_t>(count));
    for (GLint i = 0; i < count; ++i)
        glGetIntegeri_v(GL_WINDOW_RECTANGLE_EXT, static_cast<GLuint>(i),
                        &boxes_[4 * static_cast<std::size_t>(i)]);
}

void WindowRectangles::neutralise(Driver& driver) {
    if (mode_ != GL_EXCLUSIVE_EXT || !boxes_.empty()) neutraliseAll(driver);
}

void WindowRectangles::neutraliseAll(Driver& driver) {
    if (driver.functions().EXT_window_rectangles)
        glWindowRectanglesEXT(GL_EXCLUSIVE_EXT, 0, nullptr);
}

void WindowRectangles::restore(Driver&) {
    if (mode_ != GL_EXCLUSIVE_EXT || !boxes_.empty())
        glWindowRectanglesEXT(toEnum(mode_), static_cast<GLsizei>(boxes_.size() / 4),
                              boxes_.data());
}

}  // namespace sunder::gl
