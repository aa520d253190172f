#include "gpu/body_ranges.hpp"

namespace sunder::gpu {

TexelRange cellsOf(const core::World& world, int index) {
    const core::Body& body = world.bodies()[index];
    return {body.firstCell, body.firstCell + body.cellCount()};
}

std::vector<TexelRange> rangesOf(const core::World& world, const std::vector<int>& bodies) {
    std::vector<TexelRange> ranges;
    for (const int body : bodies) {
        const TexelRange own = cellsOf(world, body);
        if (!ranges.empty() && ranges.back().end == own.first)
            ranges.back().end = own.end;
        else
            ranges.push_back(own);
    }
    return ranges;
}

}  // namespace sunder::gpu
