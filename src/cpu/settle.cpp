#include "cpu/settle.hpp"

#include <algorithm>
#include <deque>
#include <set>

#include "core/memory.hpp"
#include "core/traction.hpp"
#include "cpu/collisions.hpp"
#include "cpu/relaxation.hpp"

namespace sunder::cpu {

using namespace core;

namespace {

/// Steps allowed for each group, and in steps of one cell for all: seconds on a single core. Beams,
/// walls and stacks need some hundred steps, stacks at thousands of substeps some thousand.
constexpr double kMostSteps = 30000, kWork = 5e7;
/// Cells that a stiffness wave may pass in a step; it must cross a body twice for anything to be
/// known of its rest.
constexpr double kWave = 0.55;
/// Bytes that settling takes per cell, over what a world takes.
constexpr double kBytesPerCell = 1600;
/// Edges by which cells of two bodies may come to overlap before they are taken to touch.
constexpr double kOverlap = 0.1;

bool alike(const BodyDescription& a, const BodyDescription& b) {
    const auto same = [](const RegionDescription& x, const RegionDescription& y) {
        return x.from == y.from && x.to == y.to && x.material == y.material;
    };
    return a.size == b.size && a.cells == b.cells && a.material == b.material &&
           a.anchors == b.anchors && a.position[1] == b.position[1] &&
           a.orientation.coeffs() == b.orientation.coeffs() &&
           std::equal(a.regions.begin(), a.regions.end(), b.regions.begin(), b.regions.end(), same);
}

class Settling {
  public:
    Settling(const World& world, const SettleProgress& progress, const Threads& threads)
        : world_(world),
          progress_(progress),
          threads_(threads),
          start_{world.initialState(), {}},
          standing_(world),
          groupOf_(world.bodies().size(), -1),
          steps_(static_cast<int>(std::min(kWork / world.presentCells(), kMostSteps))) {
        for (const int body : start_.state.absent) standing_.absentBodies[body] = true;
    }

    Start run() {
        for (const StandingGroup& group : standingGroups(world_, standing_)) open_.push_back(group);
        do {
            while (!open_.empty()) {
                const StandingGroup group = std::move(open_.front());
                open_.pop_front();
                settle(group);
                ++groupsDone_;
            }
        } while (joinColliding());
        for (const int body : restless_) start_.restless.push_back(world_.bodies()[body].name);
        return std::move(start_);
    }

  private:
    void settle(const StandingGroup& group) {
        if (const Twin* twin = twinOf(group)) {
            copyState(twin->body, group.bodies[0]);
            finish(group, twin->outcome, group);
            return;
        }
        if (hopeless(group)) {
            giveUp(group);
            return;
        }
        Relaxation relaxation(world_, group, threads_);
        const auto outcome = relaxation.run(start_.state, steps_, [&](double share) {
            const double groups = groupsDone_ + 1. + static_cast<double>(open_.size());
            if (progress_) progress_((groupsDone_ + share) / groups);
        });
        finish(group, outcome, relaxation.toppled());
        if (mayHaveTwins(group)) twins_.push_back({group.bodies[0], outcome});
    }

    /// Too large to find out anything with the work allowed, or in the memory there is.
    bool hopeless(const StandingGroup& group) const {
        double cells = 0, longest = 0;
        for (const int body : group.bodies) {
            cells += world_.bodies()[body].cellCount();
            longest = std::max<double>(longest, world_.bodies()[body].cells.maxCoeff());
        }
        return steps_ < 2 * longest / kWave ||
               cells * kBytesPerCell > static_cast<double>(usableMemory());
    }

    void finish(const StandingGroup& group, Relaxation::Outcome outcome,
                const StandingGroup& toppled) {
        switch (outcome) {
            case Relaxation::Outcome::Rest:
                for (const int body : group.bodies)
                    groupOf_[body] = static_cast<int>(settled_.size());
                settled_.push_back(group);
                return;
            case Relaxation::Outcome::Toppled:
                forget(group);
                for (const int body : toppled.bodies) standing_.absentBodies[body] = true;
                for (const int object : toppled.objects) standing_.absentObjects[object] = true;
                openWhatHas(group.bodies);
                return;
            case Relaxation::Outcome::OutOfSteps:
                giveUp(group);
        }
    }

    /// Opens the groups that these bodies are in now.
    void openWhatHas(const std::vector<int>& bodies) {
        for (const StandingGroup& group : standingGroups(world_, standing_))
            if (std::find_first_of(group.bodies.begin(), group.bodies.end(), bodies.begin(),
                                   bodies.end()) != group.bodies.end())
                open_.push_back(group);
    }

    /// What cannot move as a whole keeps what was reached: that is nearer to rest than nothing. The
    /// rest might topple.
    void giveUp(const StandingGroup& group) {
        restless_.insert(group.bodies.begin(), group.bodies.end());
        const bool held = std::all_of(group.bodies.begin(), group.bodies.end(),
                                      [&](int body) { return isAnchored(world_, body); });
        if (!held || !group.objects.empty()) forget(group);
    }

    /// Takes a group back to how it was described.
    void forget(const StandingGroup& group) {
        for (const int index : group.bodies) {
            const Body& body = world_.bodies()[index];
            std::fill_n(start_.state.displacement.begin() + kCorners * body.firstCell,
                        kCorners * body.cellCount(), Vec3::Zero());
            std::fill_n(start_.state.slow.begin() + kBondsPerCell * body.firstCell,
                        kBondsPerCell * body.cellCount(), 0.0);
            std::fill_n(start_.state.slowStress.begin() + body.firstCell, body.cellCount(), 0.0);
            groupOf_[index] = -1;
            std::erase_if(twins_, [index](const Twin& twin) { return twin.body == index; });
        }
        for (const int object : group.objects)
            start_.state.objects[object] = initialState(world_.description().objects[object]);
    }

    // --- bodies that touch nothing and are alike: fifty walls settle as one ---

    struct Twin {
        int body;
        Relaxation::Outcome outcome;
    };

    bool mayHaveTwins(const StandingGroup& group) const {
        const WorldDescription& d = world_.description();
        const auto holds = [](const ObjectDescription& object) {
            return object.position && (object.unyielding() || object.hungFrom);
        };
        return group.bodies.size() == 1 && group.objects.empty() && !d.room &&
               (!d.contact || std::none_of(d.objects.begin(), d.objects.end(), holds));
    }

    const Twin* twinOf(const StandingGroup& group) const {
        if (!mayHaveTwins(group)) return nullptr;
        const auto& bodies = world_.description().bodies;
        const auto found = std::find_if(twins_.begin(), twins_.end(), [&](const Twin& twin) {
            return alike(bodies[twin.body], bodies[group.bodies[0]]);
        });
        return found == twins_.end() ? nullptr : &*found;
    }

    void copyState(int from, int to) {
        State& state = start_.state;
        const Body &source = world_.bodies()[from], &target = world_.bodies()[to];
        std::copy_n(state.displacement.begin() + kCorners * source.firstCell,
                    kCorners * source.cellCount(),
                    state.displacement.begin() + kCorners * target.firstCell);
        makeStressesSlow(world_, to, state);
    }

    // --- what sags onto something that it did not touch ---

    /// Opens groups again that have come to overlap, as one, and gives up what has come to overlap
    /// something that has no rest to share. Returns whether any are open. There are fewer settled
    /// groups after each call that found some, so this ends.
    bool joinColliding() {
        if (!world_.description().contact) return false;
        std::vector<int> joined;
        for (const auto& [a, b] : collidingBodies(world_, start_.state, kOverlap)) {
            if (groupOf_[a] == groupOf_[b]) continue;
            const bool both = groupOf_[a] >= 0 && groupOf_[b] >= 0;
            for (const int body : {a, b}) {
                if (groupOf_[body] < 0) continue;
                const StandingGroup group = settled_[static_cast<std::size_t>(groupOf_[body])];
                forget(group);
                if (both)
                    joined.insert(joined.end(), group.bodies.begin(), group.bodies.end());
                else
                    restless_.insert(group.bodies.begin(), group.bodies.end());
            }
            if (both) standing_.joined.push_back({a, b});
        }
        openWhatHas(joined);
        return !open_.empty();
    }

    const World& world_;
    const SettleProgress& progress_;
    const Threads& threads_;
    Start start_;
    StandingQuery standing_;
    std::deque<StandingGroup> open_;
    std::vector<StandingGroup> settled_;
    std::vector<int> groupOf_;  ///< per body: in settled_, or −1
    std::vector<Twin> twins_;
    std::set<int> restless_;
    int steps_, groupsDone_ = 0;
};

}  // namespace

Start settledStart(const World& world, const SettleProgress& progress, const Threads& threads) {
    return Settling(world, progress, threads).run();
}

std::string restlessWarning(const Start& start) {
    if (start.restless.empty()) return {};
    std::string names;
    for (std::size_t i = 0; i < std::min<std::size_t>(start.restless.size(), 3); ++i)
        names += (i > 0 ? ", '" : "'") + start.restless[i] + "'";
    if (start.restless.size() > 3)
        names += " and " + std::to_string(start.restless.size() - 3) + " more";
    return "no state of rest was found for " + names +
           ": weight may act there as an impact when the world begins";
}

}  // namespace sunder::cpu
