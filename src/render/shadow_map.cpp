#include "render/shadow_map.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "../../glsl/draw/sun.h"
#include "render/uniforms.hpp"

namespace sunder::render {
namespace {

using glm::vec3;
const vec3 kSunDirection = glm::normalize(SUNDER_SUN_DIRECTION);

/// Texels along a side. Twice as many cost more than everything else that is drawn of fifty walls
/// on an NVIDIA H200 (1.06 of 4.1 ms, mostly clearing), and show little: wide scenes are seen from
/// afar.
constexpr int kMapSize = 2048;

/// Of the bound framebuffer: nothing veils anything.
void clearVeil() {
    constexpr float kClear[] = {1, 1, 1, 1};
    glClearBufferfv(GL_COLOR, 0, kClear);
}

}  // namespace

ShadowMap::ShadowMap(const SceneBounds& bounds, bool veiled) {
    const glm::vec3 centre = 0.5f * (bounds.lowAir + bounds.highAir);
    const glm::mat4 view = glm::lookAt(centre + kSunDirection, centre, glm::vec3(0, 1, 0));
    glm::vec3 low(std::numeric_limits<float>::max()), high = -low;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::bvec3 upper(corner & 1, corner & 2, corner & 4);
        const glm::vec3 p(view * glm::vec4(glm::mix(bounds.lowAir, bounds.highAir, upper), 1));
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    // Square texels: a shadow's edge then looks the same in every direction.
    const float width = std::max(high.x - low.x, high.y - low.y) * 1.02f;
    const glm::vec2 middle(0.5f * (low.x + high.x), 0.5f * (low.y + high.y));
    // Shadows reach the ground behind the box.
    const float depth = high.z - low.z;
    const float near = -high.z - 0.05f * depth, far = -low.z + depth;
    lightMatrix_ = glm::ortho(middle.x - width / 2, middle.x + width / 2, middle.y - width / 2,
                              middle.y + width / 2, near, far) *
                   view;
    extent_ = {width, far - near};

    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    size_ = std::min(kMapSize, largest);

    depth_ = gl::makeTexture2D(size_, size_, GL_DEPTH_COMPONENT24, "shadow map");
    gl::bindForWork(GL_TEXTURE_2D, depth_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    plain_ = gl::makeSampler();
    glSamplerParameteri(plain_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(plain_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glSamplerParameteri(plain_.id(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(plain_.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    framebuffer_ = gl::makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);

    veilSize_ = veiled ? size_ / 2 : 1;
    veil_ = gl::makeTexture2D(veilSize_, veilSize_, GL_RGBA16F, "shadow map of glass");
    gl::bindForWork(GL_TEXTURE_2D, veil_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    veilFramebuffer_ = gl::makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, veilFramebuffer_.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, veil_.id(), 0);
    clearVeil();
}

void ShadowMap::begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, size_, size_);
    glClear(GL_DEPTH_BUFFER_BIT);
}

void ShadowMap::beginVeil() const {
    glBindFramebuffer(GL_FRAMEBUFFER, veilFramebuffer_.id());
    glViewport(0, 0, veilSize_, veilSize_);
    clearVeil();
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);  // a pane counts once
    glEnable(GL_BLEND);
    glBlendEquationSeparate(GL_FUNC_ADD, GL_MIN);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
}

void ShadowMap::endVeil() {
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glEnable(GL_DEPTH_TEST);
}

void ShadowMap::prepare(const gl::Program& program) {
    program.bindSampler("shadowMap", kShadowUnit);
    program.bindSampler("shadowDepth", kShadowDepthUnit);
    program.bindSampler("shadowVeil", kShadowVeilUnit);
}

void ShadowMap::unbind() {
    glBindSampler(kShadowDepthUnit, 0);
}

void ShadowMap::bind(const gl::Program& program) const {
    const glm::mat4 toTexture =
        glm::translate(glm::mat4(1), glm::vec3(0.5f)) * glm::scale(glm::mat4(1), glm::vec3(0.5f));
    const glm::mat4 matrix = toTexture * lightMatrix_;
    setUniform(program, "shadowMatrix", matrix);
    setUniform(program, "shadowNormals", glm::transpose(glm::inverse(glm::mat3(matrix))));
    setUniform(program, "shadowSize", extent_);
    gl::bindTexture(kShadowUnit, GL_TEXTURE_2D, depth_);
    gl::bindTexture(kShadowDepthUnit, GL_TEXTURE_2D, depth_);
    glBindSampler(kShadowDepthUnit, plain_.id());
    gl::bindTexture(kShadowVeilUnit, GL_TEXTURE_2D, veil_);
}

}  // namespace sunder::render
