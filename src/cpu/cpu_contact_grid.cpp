#include "cpu/cpu_contact_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sunder::cpu {

int ContactGrid::index(float x) const {
    return static_cast<int>(std::floor(std::clamp(x * inverseEdge_, -1e9f, 1e9f)));
}
ContactGrid::Voxel ContactGrid::voxelOf(const Ball& ball) const {
    return {index(ball.x), index(ball.y), index(ball.z)};
}

/// A voxel is as wide as two balls, so that neighbours suffice; large or fast ones are left out of
/// the grid, or it would be too coarse for the rest.
int ContactGrid::prepare() {
    std::erase_if(balls_, [](const Ball& b) { return !std::isfinite(b.x + b.y + b.z + b.radius); });
    const std::size_t count = balls_.size();
    double sum = 0;
    float largest = 0;
    for (const Ball& ball : balls_) {
        sum += ball.radius;
        largest = std::max(largest, ball.radius);
    }
    const float mean = static_cast<float>(sum / std::max<double>(1, static_cast<double>(count)));
    const float bound = std::min(largest, kLarge * mean);
    bound_ = bound;
    inverseEdge_ = bound > 0 ? 0.999f / (2 * bound) : 1;
    const auto large = std::stable_partition(
        balls_.begin(), balls_.end(), [&](const Ball& ball) { return ball.radius <= bound; });
    small_ = static_cast<int>(large - balls_.begin());
    const std::size_t buckets = std::bit_ceil(2 * count + 2);
    shift_ = 32 - std::countr_zero(buckets);
    begin_.assign(buckets + 1, 0);
    for (int i = 0; i < small_; ++i) ++begin_[bucketOf(voxelOf(balls_[i])) + 1];
    for (std::size_t b = 1; b <= buckets; ++b) begin_[b] += begin_[b - 1];
    sorted_ = balls_;
    voxels_.resize(count);
    for (int i = small_; i-- > 0;) {
        const Voxel voxel = voxelOf(balls_[i]);
        // Fills each bucket from its end; afterwards begin_[b + 1] is where bucket b begins.
        const int at = --begin_[bucketOf(voxel) + 1];
        sorted_[at] = balls_[i];
        voxels_[at] = voxel;
    }
    begin_.erase(begin_.begin());
    begin_.push_back(small_);
    return (static_cast<int>(count) + kPart - 1) / kPart;
}

std::size_t ContactGrid::bytes() const {
    return (balls_.capacity() + sorted_.capacity()) * sizeof(Ball) +
           voxels_.capacity() * sizeof(Voxel) + begin_.capacity() * sizeof(int);
}

}  // namespace sunder::cpu
