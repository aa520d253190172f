#pragma once
#include <cstdint>
#include <vector>

#include "core/archive.hpp"
#include "core/rest_islands.hpp"
#include "core/sleep.hpp"
#include "cpu/cpu_body.hpp"
#include "cpu/cpu_kernels.hpp"

namespace sunder::cpu {

/// One body on its way through time.
class BodyRun {
  public:
    /// All must outlive it.
    BodyRun(const core::World& world, int body, const std::vector<Law>& laws,
            const core::EventSchedule& events);

    /// Advances from step number `from`. `split(vectors, work)` calls work(first, end, part) for
    /// parts 0..kMaxParts−1 of the vectors, in any order and in as many threads as it likes.
    template <class Split>
    void advance(std::int64_t from, int steps, const Split& split);

    /// One step in pieces, for bodies in contact, which advance together: startStep(), elements()
    /// for all parts, forces from outside, nodes() for all parts, endStep(). startStep() returns
    /// whether the body is awake; if not, the rest is left out.
    bool startStep(std::int64_t step);
    void elements(int first, int end);
    void nodes(int first, int end, int part);
    void endStep();
    const BodyArrays& arrays() const { return storage_.arrays(); }

    /// The schedule has one more event, at step `now`.
    void addPatch(const core::Event& event, std::int64_t now);
    /// These instead of all that were added.
    void setAddedPatches(const std::vector<core::Event>& events, std::int64_t now);
    /// Whether an event acts on it within steps from .. to − 1, as far as it stays where it is.
    bool pushedWithin(std::int64_t from, std::int64_t to) const {
        return events_.pushedWithin(storage_.arrays().index, from, to) || blastWithin(from, to);
    }

    /// Whether bonds that break are listed from now on.
    void listBreaks(bool list) {
        listBreaks_ = list;
        broken_.clear();
    }
    /// Calls work(bond) for those that broke since the last time.
    template <class Work>
    void takeBreaks(const Work& work) {
        for (const int bond : broken_) work(bond);
        broken_.clear();
    }
    /// m, of one of the body's nodes.
    core::Vec3 position(int node) const;

    /// Whether its anchors have let go; nothing follows yet from another answer but from relink()
    /// or load().
    void setReleased(bool released);
    void relink();
    void load(const core::State& state);
    void store(core::State& state) const;
    /// What it keeps between two steps. listed: whether breaks are, which are archived then.
    void archive(core::Archive& archive, bool listed);
    bool asleep() const { return asleep_; }
    /// Whether it has been calm for long enough to sleep.
    bool ready() const { return calmSteps_ >= sleepSteps_; }
    void fallAsleep();
    void wake() {
        asleep_ = false;
        calmSteps_ = 0;
    }
    /// Adds boxes around its cells as they are now (core/rest_islands.hpp).
    void addRestBoxes(std::vector<core::RestBox>& boxes) const;
    /// J, of a stretch of the body's vectors.
    double kineticEnergy(int first, int end) const;
    /// Wakes the body, too.
    void scaleVelocities(float factor);
    /// Whether the body may touch something: what a calm body is depends on it.
    void setTouching(bool touching) { touching_ = touching; }
    /// Changes when link masks did.
    std::uint32_t relinks() const { return relinks_; }
    int cells() const { return storage_.arrays().cells; }
    std::size_t bytes() const;

    static constexpr int kMaxParts = 64;

  private:
    /// What an event of this body pushes.
    struct Patch {
        core::Event event;
        std::vector<std::uint8_t> corners;  ///< per cell, bit per corner
    };
    struct PartNews {
        float fastest = 0;
        BondNews bonds;
    };

    template <class AnyState, class Move>
    void exchange(AnyState& state, const Move& move) const;
    void sweep(int first, int end, int part);
    void finishNodes(int first, int end, int part);
    void breakBonds(int first, int end, int part);
    void moveNodes(int first, int end, int part);
    /// The vectors of a part whose nodes touch no other part's cells: from .. to − 1.
    struct Inner {
        int from, to;
    };
    Inner inner(int first, int end) const;
    void gatherPushes(std::int64_t step);
    void gatherBlasts(std::int64_t step);
    bool blastWithin(std::int64_t from, std::int64_t to) const;
    void addBlasts(int first, int end);
    /// m, of the nodes of the cell at each place, NaN where there is none: found when the first
    /// blast is near. The world's are single-precision numbers.
    const std::vector<Eigen::Vector3f>& rest() const;
    core::Vec3 positionAt(int place, int corner) const;
    /// m, of its nodes.
    core::Box bounds() const;
    void updateSleep(bool calm);
    void listBroken();

    const core::World& world_;
    const core::EventSchedule& events_;
    BodyStorage storage_;
    std::vector<Patch> patches_;
    std::size_t ofWorld_ = 0;          ///< how many of them are of the world's events
    std::vector<Push> pushes_;         ///< at work in this step
    std::vector<core::Blast> blasts_;  ///< likewise; those that reach it
    mutable std::vector<Eigen::Vector3f> rest_;
    std::vector<PartNews> news_;
    int reach_ = 0;  ///< vectors on either side of one that its nodes' neighbours may lie in
    float calmSpeed2_ = 0, creepSpeed2_ = 0;  ///< m²/s²
    int calmSteps_ = 0, sleepSteps_ = 0;
    bool asleep_ = false, touching_ = false;
    bool check_ = false, fracture_ = false;  ///< what the step in progress has
    std::uint32_t relinks_ = 0;
    bool listBreaks_ = false;
    std::vector<int> broken_;
};

template <class Split>
void BodyRun::advance(std::int64_t from, int steps, const Split& split) {
    if (asleep_ && !pushedWithin(from, from + steps)) return;
    const int vectors = storage_.arrays().vectors;
    for (std::int64_t step = from; step < from + steps; ++step) {
        if (!startStep(step)) continue;
        split(vectors, [&](int first, int end, int part) { sweep(first, end, part); });
        split(vectors, [&](int first, int end, int part) {
            finishNodes(first, end, part);
            breakBonds(first, end, part);
        });
        endStep();
    }
}

}  // namespace sunder::cpu
