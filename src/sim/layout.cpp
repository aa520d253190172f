#include "sim/layout.hpp"

#include <utility>

namespace sunder::sim {

Layout::Layout(core::WorldDescription description) : world_(std::move(description)) {}

void Layout::upload() {
    buffers_.emplace(world_);
}

}  // namespace sunder::sim
