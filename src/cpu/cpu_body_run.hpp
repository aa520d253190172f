#pragma once
#include <cstdint>
#include <vector>

#include "core/sleep.hpp"
#include "cpu/cpu_body.hpp"
#include "cpu/cpu_kernels.hpp"

namespace sunder::cpu {

/// One body on its way through time.
class BodyRun {
  public:
    BodyRun(const World& world, int body, const std::vector<Law>& laws);

    /// Advances from step number `from`. `split(vectors, work)` calls work(first, end, part) for
    /// parts 0..kMaxParts−1 of the vectors, in any order and in as many threads as it likes.
    template <class Split>
    void advance(std::int64_t from, int steps, const Split& split);

    void load(const State& state);
    void store(State& state) const;
    bool asleep() const { return asleep_; }
    int cells() const { return storage_.arrays().cells; }
    std::size_t bytes() const;

    static constexpr int kMaxParts = 64;

  private:
    struct Patch {
        int event;
        std::vector<std::uint8_t> corners;  ///< per cell, bit per corner
    };
    struct PartNews {
        float fastest = 0;
        BondNews bonds;
    };

    void sweep(int first, int end, int part, bool fracture);
    void finishNodes(int first, int end, int part);
    void moveNodes(int first, int end, int part);
    /// The vectors of a part whose nodes touch no other part's cells: from .. to − 1.
    struct Inner {
        int from, to;
    };
    Inner inner(int first, int end) const;
    void gatherPushes(std::int64_t step);
    void updateSleep(bool calm);

    const World& world_;
    BodyStorage storage_;
    std::vector<Patch> patches_;
    std::vector<Push> pushes_;  ///< at work in this step
    std::vector<PartNews> news_;
    int reach_ = 0;         ///< vectors on either side of one that its nodes' neighbours may lie in
    float calmSpeed2_ = 0;  ///< m²/s²
    int calmSteps_ = 0, sleepSteps_ = 0;
    bool asleep_ = false;
};

template <class Split>
void BodyRun::advance(std::int64_t from, int steps, const Split& split) {
    if (asleep_ && !pushedWithin(world_, storage_.arrays().index, from, from + steps)) return;
    const int interval = world_.description().fractureInterval;
    BodyArrays& body = storage_.arrays();
    const bool breaks = body.bondsBreak || body.cellsBreak;
    for (std::int64_t step = from; step < from + steps; ++step) {
        gatherPushes(step);
        if (!pushes_.empty()) asleep_ = false;
        if (asleep_) continue;
        const bool check = step % interval == 0, fracture = check && breaks;
        split(body.vectors,
              [&](int first, int end, int part) { sweep(first, end, part, fracture); });
        split(body.vectors, [&](int first, int end, int part) {
            finishNodes(first, end, part);
            if (fracture)
                news_[part].bonds =
                    updateBonds(body, first, end, static_cast<float>(interval) * body.step);
        });
        if (!check) continue;
        bool broke = false, calm = pushes_.empty();
        for (PartNews& news : news_) {
            broke |= news.bonds.broke;
            calm &= !news.bonds.damaged && news.fastest < calmSpeed2_;
            news = {};
        }
        if (broke) relinkBroken(world_, body);
        updateSleep(calm);
    }
}

}  // namespace sunder::cpu
