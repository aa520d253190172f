#include "gl/touched_bindings.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <iterator>

namespace sunder::gl {
namespace {

struct Target {
    GLenum name, binding;
};
/// Those of the textures that Sunder makes.
constexpr Target kKnownTargets[TouchedBindings::kTargets] = {
    {GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER},
    {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
    {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
    {GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE},
};

}  // namespace

void TouchedBindings::note(int unit, GLenum target) {
    assert(unit >= 0 && unit < kUnits);
    const auto at = static_cast<std::size_t>(unit);
    if (!unitsSeen_[at]) {
        unitsSeen_[at] = true;
        // A sampler object overrules the texture's own filter: with one, a texture of a single
        // level may count as incomplete and read as black.
        const GLuint sampler = mode_ == Mode::Noted ? boundName(GL_SAMPLER_BINDING) : 0;
        if (sampler != 0) samplers_.push_back({static_cast<GLuint>(unit), sampler});
        if (sampler != 0 || mode_ == Mode::Cleared) glBindSampler(static_cast<GLuint>(unit), 0);
    }
    if (mode_ != Mode::Noted) return;
    const auto* known = std::find_if(std::begin(kKnownTargets), std::end(kKnownTargets),
                                     [&](const Target& some) { return some.name == target; });
    assert(known != std::end(kKnownTargets));
    auto seen = texturesSeen_[static_cast<std::size_t>(known - kKnownTargets)][at];
    if (seen) return;
    seen = true;
    textures_.push_back(
        {GL_TEXTURE0 + static_cast<GLenum>(unit), target, boundName(known->binding)});
}

void TouchedBindings::note(int binding) {
    assert(binding >= 0 && binding < kUniformBlocks);
    auto seen = blocksSeen_[static_cast<std::size_t>(binding)];
    if (seen) return;
    seen = true;
    const auto index = static_cast<GLuint>(binding);
    GLint buffer = 0;
    GLint64 start = 0, size = 0;
    glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, index, &buffer);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_START, index, &start);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, index, &size);
    uniforms_.push_back({index, static_cast<GLuint>(buffer), start, size});
}

void TouchedBindings::noteImage(int unit) {
    assert(unit >= 0 && unit < kImages);
    auto seen = imagesSeen_[static_cast<std::size_t>(unit)];
    if (seen) return;
    seen = true;
    const auto index = static_cast<GLuint>(unit);
    const auto get = [&](GLenum what) {
        GLint value = 0;
        glGetIntegeri_v(what, index, &value);
        return value;
    };
    images_.push_back({index, get(GL_IMAGE_BINDING_NAME), get(GL_IMAGE_BINDING_LEVEL),
                       get(GL_IMAGE_BINDING_LAYERED), get(GL_IMAGE_BINDING_LAYER),
                       get(GL_IMAGE_BINDING_ACCESS), get(GL_IMAGE_BINDING_FORMAT)});
}

void TouchedBindings::end() {
    for (const BoundTexture& before : textures_) {
        glActiveTexture(before.unit);
        glBindTexture(before.target, before.texture);
    }
    for (const BoundSampler& before : samplers_) glBindSampler(before.unit, before.sampler);
    for (const BoundUniforms& before : uniforms_)
        // 0 bytes: bound by glBindBufferBase, all of the buffer whatever its size (GL 4.1, table
        // 6.28).
        if (before.size == 0)
            glBindBufferBase(GL_UNIFORM_BUFFER, before.binding, before.buffer);
        else
            glBindBufferRange(GL_UNIFORM_BUFFER, before.binding, before.buffer,
                              static_cast<GLintptr>(before.start),
                              static_cast<GLsizeiptr>(before.size));
    for (const BoundImage& before : images_)
        glBindImageTexture(before.unit, static_cast<GLuint>(before.texture), before.level,
                           before.layered != 0, before.layer, static_cast<GLenum>(before.access),
                           static_cast<GLenum>(before.format));
    images_.clear();
    imagesSeen_.reset();
    textures_.clear();
    samplers_.clear();
    uniforms_.clear();
    unitsSeen_.reset();
    blocksSeen_.reset();
    for (auto& seen : texturesSeen_) seen.reset();
    mode_ = Mode::Off;
}

}  // namespace sunder::gl
