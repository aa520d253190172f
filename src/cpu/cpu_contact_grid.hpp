#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace sunder::cpu {

/// Finds balls that overlap, by a grid of voxels in a hash table.
class ContactGrid {
  public:
    struct Ball {
        float x, y, z, radius;
        int number;
    };
    struct Candidate {
        int a, b;
    };
    void clear() { balls_.clear(); }
    void add(const Ball& ball) { balls_.push_back(ball); }
    /// Sorts the balls; returns the number of parts that find() can be called for.
    int prepare();
    /// Appends the pairs of overlapping balls of a part, each once. `wanted` has the last word.
    template <class W>
    void find(int part, const W& wanted, std::vector<Candidate>& found) const;

    std::size_t bytes() const;

  private:
    struct Voxel {
        int x, y, z;
        bool operator==(const Voxel&) const = default;
    };
    static constexpr int kPart = 256;      ///< balls
    static constexpr float kLarge = 1.6f;  ///< mean radii

    int index(float x) const;
    Voxel voxelOf(const Ball& ball) const;
    /// Calls test(j) for the small balls that a large one may overlap.
    template <class Test>
    void around(const Ball& large, const Test& test) const;
    std::size_t bucketOf(const Voxel& v) const {
        const std::uint32_t sum = static_cast<std::uint32_t>(v.x) * 0x8da6b343u +
                                  static_cast<std::uint32_t>(v.y) * 0xd8163841u +
                                  static_cast<std::uint32_t>(v.z) * 0xcb1ab31fu;
        // Mixed once more, or walls in regular rows fall into the same buckets.
        return (sum ^ sum >> 15) * 0x2c1b3c6du >> shift_;
    }
    static bool overlap(const Ball& a, const Ball& b) {
        const float x = a.x - b.x, y = a.y - b.y, z = a.z - b.z, r = a.radius + b.radius;
        return x * x + y * y + z * z < r * r;
    }

    std::vector<Ball> balls_, sorted_;  ///< sorted_: by bucket, then the large ones
    std::vector<Voxel> voxels_;         ///< of sorted_
    std::vector<int> begin_;            ///< per bucket
    int small_ = 0;                     ///< balls no larger than a voxel
    float bound_ = 0;                   ///< m, radius of the largest of them
    float inverseEdge_ = 1;             ///< 1/m
    int shift_ = 31;
};

template <class Test>
void ContactGrid::around(const Ball& large, const Test& test) const {
    const float reach = large.radius + bound_;
    const Voxel low{index(large.x - reach), index(large.y - reach), index(large.z - reach)};
    const Voxel high{index(large.x + reach), index(large.y + reach), index(large.z + reach)};
    const double voxels = (high.x - low.x + 1.) * (high.y - low.y + 1.) * (high.z - low.z + 1.);
    if (voxels > small_) {
        for (int j = 0; j < small_; ++j) test(j);
        return;
    }
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                const Voxel v{x, y, z};
                const std::size_t bucket = bucketOf(v);
                for (int j = begin_[bucket]; j < begin_[bucket + 1]; ++j)
                    if (voxels_[j] == v) test(j);
            }
}

template <class W>
void ContactGrid::find(int part, const W& wanted, std::vector<Candidate>& found) const {
    const int count = static_cast<int>(sorted_.size());
    const auto test = [&](int i, int j) {
        if (overlap(sorted_[i], sorted_[j]) && wanted(sorted_[i].number, sorted_[j].number))
            found.push_back({sorted_[i].number, sorted_[j].number});
    };
    for (int i = part * kPart; i < std::min(count, (part + 1) * kPart); ++i) {
        if (i >= small_) {
            around(sorted_[i], [&](int j) { test(i, j); });
            for (int j = i + 1; j < count; ++j) test(i, j);
            continue;
        }
        // Its own voxel, and the thirteen neighbours that come after it.
        const Voxel own = voxels_[i];
        for (int n = 13; n < 27; ++n) {
            const Voxel v{own.x + n % 3 - 1, own.y + n / 3 % 3 - 1, own.z + n / 9 - 1};
            const std::size_t bucket = bucketOf(v);
            const int from = n == 13 ? i + 1 : begin_[bucket];
            for (int j = from; j < begin_[bucket + 1]; ++j)
                if (voxels_[j] == v) test(i, j);
        }
    }
}

}  // namespace sunder::cpu
