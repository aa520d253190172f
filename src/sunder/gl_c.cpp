#include "sunder/c_handles.hpp"
#include "sunder/gl.hpp"
#include "sunder/guard.hpp"

using namespace sunder;

struct sunder_surface {
    sunder_surface(gl::Device& device, World& world) : surface(device, world) {
        for (const gl::Range& range : surface.ranges())
            ranges.push_back({range.material, range.inside, range.transparent, range.count,
                              reinterpret_cast<std::size_t>(range.offset)});
    }
    gl::Surface surface;
    std::vector<sunder_range> ranges;
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

sunder_surface* sunder_surface_create(sunder_device* device, sunder_world* world) {
    try {
        if (!device || !world) throw core::InputError("a surface needs a device and a world");
        auto made =
            std::make_unique<sunder_surface>(static_cast<GlDevice*>(device)->adopted, world->world);
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

size_t sunder_surface_ranges(const sunder_surface* surface, const sunder_range** ranges) {
    *ranges = surface->ranges.data();
    return surface->ranges.size();
}
