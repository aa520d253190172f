#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "core/types.hpp"

namespace sunder::core {

/// A box along the axes.
struct Box {
    Vec3 low{0, 0, 0}, high{0, 0, 0};  ///< m

    Vec3 centre() const { return 0.5 * (low + high); }
    /// Boxes that only share a face do not.
    bool overlaps(const Box& other) const {
        return (low.array() < other.high.array()).all() && (high.array() > other.low.array()).all();
    }
    void include(const Box& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
};

/// Calls visit(i, j), i < j, for every two boxes that overlap, always in the same order, by a tree
/// of boxes. Returns how often two boxes were compared: for n boxes of which each overlaps a few
/// about n·log n.
std::int64_t forEachOverlap(std::span<const Box> boxes, const std::function<void(int, int)>& visit);

}  // namespace sunder::core
