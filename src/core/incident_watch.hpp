#pragma once
#include <functional>
#include <vector>

#include "core/incident.hpp"

namespace sunder::core {

class Archive;

/// Collects incidents for a solver on the CPU and hands them over at every look, by cell: first its
/// breaks, then its contact.
class IncidentWatch {
  public:
    IncidentWatch(const World& world, IncidentRing& ring);

    /// In a step, a cell gets an impulse (N·s), the `hardest` part of it from a cell or an object;
    /// the other one is −1. May be called for different cells at the same time.
    void push(int cell, double impulse, double hardest, int other, int object);
    void broke(int bond) { broken_.push_back(bond); }
    /// The state was set: what happened before does not count.
    void forget();
    /// What happened since the last look, and what that compares with. watch: null where nobody
    /// looks: what was saved of one is left out, and one that nothing was saved of forgets.
    static void archive(Archive& archive, const World& world, IncidentWatch* watch);

    /// Whether a look is due when `step` steps are done.
    bool due(std::int64_t step) const { return step % interval_ == 0; }
    /// The first step after `step` that a look is due at.
    std::int64_t next(std::int64_t step) const { return (step / interval_ + 1) * interval_; }
    /// place: m, of a node.
    void look(std::int64_t step, const std::function<Vec3(int node)>& place);

  private:
    struct Load {
        double now = 0, before = 0, earlier = 0;  ///< N·s: since the last look, in the two before
        double hardest = 0;                       ///< N·s, in one step
        int other = -1, object = -1;              ///< who gave that
    };

    const World& world_;
    IncidentRing& ring_;
    int interval_;
    std::vector<int> broken_;  ///< bonds, since the last look
    std::vector<Load> loads_;  ///< per cell, with contact
};

}  // namespace sunder::core
