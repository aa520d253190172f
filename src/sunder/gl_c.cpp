#include "sunder/c_handles.hpp"
#include "sunder/gl.hpp"
#include "sunder/guard.hpp"

using namespace sunder;

struct sunder_surface {
    sunder_surface(gl::Device& device, World& world, const gl::SurfaceOptions& options)
        : surface(device, world, options) {}
    gl::Surface surface;
    std::vector<sunder_range> ranges;
    std::vector<sunder_vertex_range> changed;
    std::string shader;
};

namespace {

struct GlDevice : sunder_device {
    explicit GlDevice(gl::DeviceOptions options) : adopted(std::move(options)) {}
    gl::Device& device() override { return adopted; }
    gl::Device adopted;
};

}  // namespace

sunder_device* sunder_device_create(sunder_get_proc_address find, int dirty) {
    try {
        gl::DeviceOptions options;
        if (find) options.getProcAddress = find;
        if (dirty) options.state = gl::State::Dirty;
        auto made = std::make_unique<GlDevice>(std::move(options));
        if (made->adopted.ok()) return made.release();
        fail(made->adopted.error());
    } catch (...) {
        fail(currentError());
    }
    return nullptr;
}

void sunder_device_destroy(sunder_device* device) {
    delete device;
}

sunder_surface* sunder_surface_create(sunder_device* device, sunder_world* world, int pieces) {
    try {
        if (!device || !world) throw core::InputError("a surface needs a device and a world");
        auto made = std::make_unique<sunder_surface>(static_cast<GlDevice*>(device)->adopted,
                                                     world->world, gl::SurfaceOptions{pieces != 0});
        if (made->surface.ok()) return made.release();
        fail(made->surface.error());
    } catch (...) {
        fail(currentError());
    }
    return nullptr;
}

void sunder_surface_destroy(sunder_surface* surface) {
    delete surface;
}

sunder_status sunder_surface_update(sunder_surface* surface) {
    if (!surface) return fail({Error::Code::Input, "the surface is null"});
    return statusOf(surface->surface.update());
}

unsigned sunder_surface_vertex_array(const sunder_surface* surface) {
    return surface->surface.vertexArray();
}

unsigned sunder_surface_vertex_buffer(const sunder_surface* surface) {
    return surface->surface.vertexBuffer();
}

unsigned sunder_surface_rest_buffer(const sunder_surface* surface) {
    return surface->surface.restBuffer();
}

unsigned sunder_surface_piece_buffer(const sunder_surface* surface) {
    return surface->surface.pieceBuffer();
}

unsigned sunder_surface_index_buffer(const sunder_surface* surface) {
    return surface->surface.indexBuffer();
}

unsigned sunder_surface_source_array(const sunder_surface* surface) {
    return surface->surface.sourceArray();
}

int sunder_surface_vertices(const sunder_surface* surface) {
    return surface->surface.vertices();
}

size_t sunder_surface_changed(sunder_surface* surface, const sunder_vertex_range** changed) {
    surface->changed.clear();
    for (const gl::VertexRange& range : surface->surface.changed())
        surface->changed.push_back({range.body, range.first, range.count});
    *changed = surface->changed.data();
    return surface->changed.size();
}

sunder_status sunder_surface_vertex_shader(sunder_surface* surface, const char** text) {
    if (!surface || !text) return fail({Error::Code::Input, "the surface or the text is null"});
    Result<std::string> shader = surface->surface.vertexShader();
    if (!shader) return fail(shader.error());
    surface->shader = std::move(*shader);
    *text = surface->shader.c_str();
    return SUNDER_OK;
}

sunder_status sunder_surface_vertex_textures(sunder_surface* surface,
                                             sunder_vertex_texture* textures) {
    if (!surface || !textures)
        return fail({Error::Code::Input, "the surface or the textures are null"});
    const auto found = surface->surface.vertexTextures();
    if (!found) return fail(found.error());
    for (const gl::VertexTexture& texture : *found)
        *textures++ = {texture.sampler, texture.texture};
    return SUNDER_OK;
}

size_t sunder_surface_ranges(sunder_surface* surface, const sunder_range** ranges) {
    surface->ranges.clear();
    for (const gl::Range& range : surface->surface.ranges())
        surface->ranges.push_back({range.material, range.inside, range.transparent, range.count,
                                   reinterpret_cast<std::size_t>(range.offset)});
    *ranges = surface->ranges.data();
    return surface->ranges.size();
}
