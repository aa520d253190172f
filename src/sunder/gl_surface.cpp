#include <algorithm>
#include <utility>

#include "core/pieces.hpp"
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
    /// Makes all of it, of the world as it is laid out now. Within a stay.
    void make();
    /// Where the world has been laid out anew since. Within a stay.
    void follow() {
        if (layout != world->impl().layout) make();
    }
    void updatePieces();

    Device::Impl* device = nullptr;
    World* world = nullptr;
    bool pieces = false;
    Error error;
    std::shared_ptr<const sim::Layout> layout;  ///< that all of this is of
    /// Of a world that is not on this GPU.
    std::optional<gpu::WorldBuffers> buffers;
    const gpu::WorldBuffers* worldBuffers = nullptr;  ///< those, or the world's own
    std::optional<sim_gl::DrawnState> state;
    std::optional<sim_gl::DeformedMesh> mesh;  ///< none where it could not be made
    std::vector<Range> ranges;
    std::vector<std::int64_t> drawn;   ///< version of each body that was drawn; −1: none
    std::vector<VertexRange> changed;  ///< by the last update
    std::int64_t labelled = -1;        ///< step of the state whose pieces are known
    std::vector<double> damage;        ///< of that state
    std::vector<int> absent;           ///< likewise
};

void Surface::Impl::make() {
    World::Impl& inside = world->impl();
    mesh.reset();
    state.reset();
    buffers.reset();
    ranges.clear();
    layout = inside.layout;
    worldBuffers = layout->buffers();
    if (!worldBuffers) worldBuffers = &buffers.emplace(inside.world());
    state.emplace(*inside.simulation);
    mesh.emplace(inside.world(), *worldBuffers, pieces);
    for (const sim_gl::DeformedMesh::Range& range : mesh->ranges())
        ranges.push_back({range.material, range.inside, range.transparent, range.count,
                          reinterpret_cast<const void*>(sizeof(std::uint32_t) *
                                                        static_cast<std::size_t>(range.first))});
    drawn.assign(inside.world().bodies().size(), -1);
    labelled = -1;
    damage.clear();
}

void Surface::Impl::updatePieces() {
    sim::Simulation& simulation = *world->impl().simulation;
    const core::State& seen = simulation.lateState();
    if (seen.step == labelled && seen.absent == absent) return;
    labelled = seen.step;
    if (seen.damage == damage && seen.absent == absent) return;
    damage = seen.damage;
    absent = seen.absent;
    mesh->setPieces(core::findPieces(simulation.world(), seen).ofCell);
}

Surface::Surface(Device& device, World& world, const SurfaceOptions& options)
    : impl_(std::make_unique<Impl>()) {
    const Result<void> made = guarded([&]() -> Result<void> {
        if (!device.ok()) return device.error();
        impl_->device = &device.impl();
        impl_->world = &world;
        impl_->pieces = options.pieces;
        const auto stay = impl_->device->enter();
        impl_->make();
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
    impl_->layout.reset();
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
        Impl& s = *impl_;
        const auto stay = s.device->enter();
        s.follow();
        const sim::Simulation& simulation = *s.world->impl().simulation;
        std::vector<int> bodies;
        s.changed.clear();
        for (int body = 0; body < static_cast<int>(s.drawn.size()); ++body) {
            const std::int64_t version = simulation.version(body);
            if (std::exchange(s.drawn[body], version) == version) continue;
            bodies.push_back(body);
            const sim_gl::DeformedMesh::Part part = s.mesh->part(body);
            s.changed.push_back({part.body, part.first, part.count});
        }
        if (!bodies.empty()) s.mesh->update(s.state->view(), bodies);
        if (s.pieces) s.updatePieces();
        s.device->check();
        return {};
    });
}

Result<std::string> Surface::vertexShader() {
    if (!ok()) return error();
    return guarded([&]() -> Result<std::string> {
        const auto stay = impl_->device->enter();
        impl_->follow();
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
        impl_->follow();
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

unsigned Surface::pieceBuffer() const {
    return ok() ? impl_->mesh->pieceBuffer() : 0;
}

std::span<const VertexRange> Surface::changed() const {
    return impl_->changed;
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
