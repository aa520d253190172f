#include "render/surface_textures.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include "gl/device_info.hpp"
#include "render/uniforms.hpp"

namespace sunder::render {

using namespace core;

namespace {

/// Texels along an edge: two millimetres or less for the largest layer, concrete.
constexpr int kSide = 512;
/// Mipmaps, down to 8 x 8: what is smaller has one colour.
constexpr int kLevels = 6;
/// More of it shows no difference here.
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

/// Anisotropic filtering is an extension that every driver has, but none must have before GL 4.6.
/// Mesa's software driver has it too: a picture then takes ten times as long.
bool anisotropyPays() {
    const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    if (gl::isSoftware(renderer ? renderer : "")) return false;
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto* name = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i));
        if (std::string_view(name).ends_with("_texture_filter_anisotropic")) return true;
    }
    return false;
}

/// Of the 2D array texture that is bound.
void filterWithMipmaps() {
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, kLevels);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    if (!anisotropyPays()) return;
    constexpr GLenum kAnisotropyName = 0x84FE, kLimitName = 0x84FF;  // not in GL 4.1's header
    float most = 1;
    glGetFloatv(kLimitName, &most);
    glTexParameterf(GL_TEXTURE_2D_ARRAY, kAnisotropyName, std::min(kAnisotropy, most));
}

/// Draws layers, each with a program of its own: together they take a driver a second to compile.
class LayerBake {
  public:
    explicit LayerBake(const gl::VertexArray& noAttributes)
        : finishing_({.vertex = "bake/whole.vert", .fragment = "bake/slopes.frag"}),
          draft_(gl::makeTexture2D(kSide, kSide, GL_RGBA32F, "draft of a surface texture")),
          drafted_(gl::makeFramebuffer()),
          finished_(gl::makeFramebuffer()) {
        finishing_.bindSampler("bakedLayer", kSurfaceUnit);
        glBindFramebuffer(GL_FRAMEBUFFER, drafted_.id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, draft_.id(), 0);
        glBindVertexArray(noAttributes.id());
        glViewport(0, 0, kSide, kSide);
    }

    void draw(int layer, const gl::Texture& layers, int place) const {
        const gl::Program drawing({.vertex = "bake/whole.vert",
                                   .fragment = "bake/surface.frag",
                                   .defines = {{"LAYER", std::to_string(layer)}}});
        glBindFramebuffer(GL_FRAMEBUFFER, drafted_.id());
        drawing.use();
        glUniform1i(drawing.uniform("side"), kSide);
        glDrawArrays(GL_TRIANGLES, 0, 3);

        glBindFramebuffer(GL_FRAMEBUFFER, finished_.id());
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, layers.id(), 0, place);
        finishing_.use();
        glUniform1i(finishing_.uniform("layer"), layer);
        gl::bindTexture(kSurfaceUnit, GL_TEXTURE_2D, draft_);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

  private:
    gl::Program finishing_;
    gl::Texture draft_;
    gl::Framebuffer drafted_, finished_;
};

}  // namespace

SurfaceTextures::SurfaceTextures(const World& world, const gl::VertexArray& noAttributes)
    : made_(layersOf(world)) {
    layers_ = gl::makeTextureArray(kSide, kSide, static_cast<int>(made_.size()), GL_RGBA8,
                                   "surface textures");
    const LayerBake bake(noAttributes);
    int place = 0;
    for (const int layer : made_) {
        bake.draw(layer, layers_, place);
        places_[layer] = place++;
    }
    gl::bindTexture(kSurfaceUnit, GL_TEXTURE_2D_ARRAY, layers_);
    filterWithMipmaps();
}

bool SurfaceTextures::fits(const World& world) const {
    return made_ == layersOf(world);
}

void SurfaceTextures::prepare(const gl::Program& program) {
    program.bindSampler("surfaces", kSurfaceUnit);
}

void SurfaceTextures::bind(const gl::Program& program) const {
    glUniform1iv(program.uniform("surfaceLayers"), SUNDER_SURFACE_LAYERS, places_.data());
    gl::bindTexture(kSurfaceUnit, GL_TEXTURE_2D_ARRAY, layers_);
}

}  // namespace sunder::render
