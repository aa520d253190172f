#include "render/transparency.hpp"

#include "render/uniforms.hpp"

namespace sunder::render {

Transparency::Transparency(const gl::VertexArray& noAttributes) : noAttributes_(noAttributes) {}

void Transparency::fit(const PictureTarget& target) {
    if (depth_ == target.depth().id()) return;
    light_ = makeSamples(target.width(), target.height(), target.sampleCount(), GL_RGBA16F);
    transmission_ = makeSamples(target.width(), target.height(), target.sampleCount(), GL_R16F);
    framebuffer_ = gl::makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    const auto attach = [&](GLenum point, const gl::Texture& texture) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, point, target.textureTarget(), texture.id(), 0);
    };
    attach(GL_COLOR_ATTACHMENT0, light_);
    attach(GL_COLOR_ATTACHMENT1, transmission_);
    attach(GL_DEPTH_ATTACHMENT, target.depth());
    constexpr GLenum kTargets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, kTargets);
    requireComplete(target.width(), target.height());
    depth_ = target.depth().id();

    const char* samples = target.sampleCount() > 1 ? "1" : "0";
    overlay_ = gl::Program({.vertex = "bake/whole.vert",
                            .fragment = "draw/transparent.frag",
                            .defines = {{"SAMPLES", samples}}});
    overlay_.bindSampler("lightSum", kLightSumUnit);
    overlay_.bindSampler("transmission", kTransmissionUnit);
}

void Transparency::draw(const PictureTarget& target, const std::function<void()>& pass) {
    fit(target);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    constexpr float kDark[] = {0, 0, 0, 0}, kClear[] = {1, 1, 1, 1};
    glClearBufferfv(GL_COLOR, 0, kDark);
    glClearBufferfv(GL_COLOR, 1, kClear);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunci(0, GL_ONE, GL_ONE);
    glBlendFunci(1, GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
    pass();

    target.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glBlendFunc(GL_ONE, GL_SRC_ALPHA);
    overlay_.use();
    gl::bindTexture(kLightSumUnit, target.textureTarget(), light_);
    gl::bindTexture(kTransmissionUnit, target.textureTarget(), transmission_);
    glBindVertexArray(noAttributes_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
}

}  // namespace sunder::render
