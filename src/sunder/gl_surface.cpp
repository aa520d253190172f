#include <algorithm>

#include "gpu/feedback.hpp"
#include "sim_gl/deformed_mesh.hpp"
#include "sim_gl/drawn_state.hpp"
#include "sim_gl/host_vertex.hpp"
#include "sunder/gl_device.hpp"
#include "sunder/guard.hpp"
#include "sunder/world_impl.hpp"

namespace sunder::gl {

static_assert(sizeof(Vertex) == sizeof(sim_gl::DeformedMesh::Vertex));
static_assert(sizeof(RestVertex) == sizeof(sim_gl::DeformedMesh::RestVertex));

struct Surface::Impl {
    Device::Impl* device = nullptr;
    Error error;
    /// Of a world that is not on this GPU.
    std::optional<gpu::WorldBuffers> buffers;
    const gpu::WorldBuffers* worldBuffers = nullptr;  ///< those, or the world's own
    std::optional<sim_gl::DrawnState> state;
    std::optional<sim_gl::DeformedMesh> mesh;  ///< none where it could not be made
    std::vector<Range> ranges;
};

Surface::Surface(Device& device, World& world) : impl_(std::make_unique<Impl>()) {
    const Result<void> made = guarded([&]() -> Result<void> {
        if (!device.ok()) return device.error();
        impl_->device = &device.impl();
        const auto stay = impl_->device->enter();
        World::Impl& inside = world.impl();
        const gpu::WorldBuffers* buffers = inside.layout->buffers();
        if (!buffers) buffers = &impl_->buffers.emplace(inside.world());
        impl_->worldBuffers = buffers;
        impl_->state.emplace(*inside.simulation);
        impl_->mesh.emplace(inside.world(), *buffers);
        for (const sim_gl::DeformedMesh::Range& range : impl_->mesh->ranges())
            impl_->ranges.push_back(
                {range.material, range.inside, range.transparent, range.count,
                 reinterpret_cast<const void*>(sizeof(std::uint32_t) *
                                               static_cast<std::size_t>(range.first))});
        impl_->device->check();
        return {};
    });
    if (made) return;
    impl_->error = made.error();
    impl_->mesh.reset();
}

Surface::~Surface() {
    if (!impl_->device) return;
    const auto stay = impl_->device->enter(sim::Backend::Work::Deletes);
    impl_->mesh.reset();
    impl_->state.reset();
    impl_->buffers.reset();
}

bool Surface::ok() const {
    return impl_->mesh.has_value();
}

const Error& Surface::error() const {
    return impl_->error;
}

Result<void> Surface::update() {
    if (!ok()) return error();
    return guarded([&]() -> Result<void> {
        const auto stay = impl_->device->enter();
        impl_->mesh->update(impl_->state->view());
        impl_->device->check();
        return {};
    });
}

Result<std::string> Surface::vertexShader() {
    if (!ok()) return error();
    return guarded([&]() -> Result<std::string> {
        const auto stay = impl_->device->enter();
        std::string text =
            sim_gl::hostVertexShader(impl_->state->view(), impl_->worldBuffers->turned());
        impl_->device->check();
        return text;
    });
}

Result<std::array<VertexTexture, 5>> Surface::vertexTextures() {
    if (!ok()) return error();
    return guarded([&]() -> Result<std::array<VertexTexture, 5>> {
        const auto stay = impl_->device->enter();
        std::array<VertexTexture, 5> textures{};
        const auto found = sim_gl::hostTextures(*impl_->worldBuffers, impl_->state->view());
        std::transform(found.begin(), found.end(), textures.begin(),
                       [](const sim_gl::HostTexture& of) {
                           return VertexTexture{of.sampler, of.texture};
                       });
        impl_->device->check();
        return textures;
    });
}

unsigned Surface::sourceArray() const {
    return ok() ? impl_->mesh->boundArray() : 0;
}

unsigned Surface::vertexArray() const {
    return ok() ? impl_->mesh->vertexArray() : 0;
}

unsigned Surface::vertexBuffer() const {
    return ok() ? impl_->mesh->vertexBuffer() : 0;
}

unsigned Surface::restBuffer() const {
    return ok() ? impl_->mesh->restBuffer() : 0;
}

unsigned Surface::indexBuffer() const {
    return ok() ? impl_->mesh->indexBuffer() : 0;
}

int Surface::vertices() const {
    return ok() ? impl_->mesh->vertices() : 0;
}

std::span<const Range> Surface::ranges() const {
    return impl_->ranges;
}

}  // namespace sunder::gl
