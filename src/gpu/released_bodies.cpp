#include "gpu/released_bodies.hpp"

#include <vector>

namespace sunder::gpu {

ReleasedBodies::ReleasedBodies(const core::World& world)
    : bodies_(world.bodies().size()),
      buffer_(gl::makeBuffer<float>(std::vector<float>(bodies_), GL_DYNAMIC_DRAW, "released")),
      texture_(gl::makeBufferTexture(buffer_, GL_R32F, "released")) {}

void ReleasedBodies::write(const core::BodyBook& book) {
    std::vector<float> released(bodies_);
    for (const int body : book.released()) released[body] = 1;
    buffer_.write(0, sizeof(float) * released.size(), released.data());
}

}  // namespace sunder::gpu
