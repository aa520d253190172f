#include "render/surface_textures.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include "../../glsl/draw/surface_layers.h"
#include "render/uniforms.hpp"

namespace sunder {
namespace {

/// Texels along an edge: two millimetres or less for the largest layer, concrete.
constexpr int kSide = 512;
/// More of it shows no difference here, and software pays for every sample.
constexpr float kAnisotropy = 4;

std::set<int> layersOf(SurfaceKind kind) {
    switch (kind) {
        case SurfaceKind::Wood:
            return {SUNDER_LAYER_WOOD, SUNDER_LAYER_WOOD_END, SUNDER_LAYER_WOOD_SPLIT};
        case SurfaceKind::Brick:
            return {SUNDER_LAYER_BRICK, SUNDER_LAYER_BRICK_SPLIT, SUNDER_LAYER_MORTAR};
        case SurfaceKind::Concrete:
            return {SUNDER_LAYER_CONCRETE, SUNDER_LAYER_CONCRETE_SPLIT};
        case SurfaceKind::Rubber:
            return {SUNDER_LAYER_RUBBER};
        case SurfaceKind::Plain:
        case SurfaceKind::Glass:
            break;
    }
    return {};
}

std::set<int> layersOf(const World& world) {
    std::set<int> layers{SUNDER_LAYER_CLOUDS};
    if (world.description().ground) layers.insert(SUNDER_LAYER_CONCRETE);
    for (const Material& material : world.description().materials)
        layers.merge(layersOf(material.surface));
    return layers;
}

void setFiltering(const gl::Texture& texture) {
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture.id());
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 1000);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_REPEAT);
}

/// An extension that every driver has, but none must have before GL 4.6.
bool hasAnisotropy() {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* name = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i));
        if (std::string_view(name).ends_with("_texture_filter_anisotropic")) return true;
    }
    return false;
}

}  // namespace

SurfaceTextures::SurfaceTextures(const World& world, const gl::VertexArray& noAttributes)
    : layers_(
          gl::makeTextureArray(kSide, kSide, SUNDER_SURFACE_LAYERS, GL_RGBA8, "surface textures")) {
    const gl::Program drawing({.vertex = "bake/whole.vert", .fragment = "bake/surface.frag"});
    const gl::Program finishing({.vertex = "bake/whole.vert", .fragment = "bake/slopes.frag"});
    finishing.bindSampler("bakedLayer", kSurfaceUnit);
    const gl::Texture draft = gl::makeTexture2D(kSide, kSide, GL_RGBA32F, "surface texture draft");
    const gl::Framebuffer drafted = gl::makeFramebuffer(), finished = gl::makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, drafted.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, draft.id(), 0);
    glBindVertexArray(noAttributes.id());
    glViewport(0, 0, kSide, kSide);
    for (const int layer : layersOf(world)) {
        glBindFramebuffer(GL_FRAMEBUFFER, drafted.id());
        drawing.use();
        glUniform1i(drawing.uniform("layer"), layer);
        glUniform1i(drawing.uniform("side"), kSide);
        glDrawArrays(GL_TRIANGLES, 0, 3);

        glBindFramebuffer(GL_FRAMEBUFFER, finished.id());
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, layers_.id(), 0, layer);
        finishing.use();
        glUniform1i(finishing.uniform("layer"), layer);
        gl::bindTexture(kSurfaceUnit, GL_TEXTURE_2D, draft);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    setFiltering(layers_);
    glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    if (hasAnisotropy()) {
        constexpr GLenum kAnisotropyName = 0x84FE, kLimitName = 0x84FF;  // not in GL 4.1's header
        float most = 1;
        glGetFloatv(kLimitName, &most);
        glTexParameterf(GL_TEXTURE_2D_ARRAY, kAnisotropyName, std::min(kAnisotropy, most));
    }
}

void SurfaceTextures::prepare(const gl::Program& program) {
    program.bindSampler("surfaces", kSurfaceUnit);
}

void SurfaceTextures::bind() const {
    gl::bindTexture(kSurfaceUnit, GL_TEXTURE_2D_ARRAY, layers_);
}

}  // namespace sunder
