#pragma once
#include <memory>
#include <vector>

#include "core/solver.hpp"

namespace sunder {

/// What a game would ship: several cells at once on every core, single precision. Bodies are shared
/// out to the cores whole where there are enough of them; a large one is split into stretches of
/// cells. The result does not depend on the number of cores or the width of their vectors.
///
/// A body falls asleep once it has been calm for kSleepDelay seconds of simulated time: no node
/// faster than kSleepSpeed cell edges a second (a thousandth of an edge per 1/60 s), no event at
/// work, no damage growing. (Half a second at such speeds bounds the mean acceleration, too, at
/// 4·kSleepSpeed edges/s²; a body that starts to fall is past the limit within milliseconds.) Its
/// velocities become zero, and from then on it does not change by a bit and costs nothing, until
/// an event on it or setState() wakes it.
class CpuSolver : public Solver {
  public:
    static constexpr double kSleepSpeed = 0.06;  ///< cell edges/s
    static constexpr double kSleepDelay = 0.5;   ///< s

    /// `world` must outlive the solver. threads: 0 for one per core.
    explicit CpuSolver(const World& world, int threads = 0);
    ~CpuSolver() override;

    std::string_view name() const override { return "cpu"; }
    void advance(int steps) override;
    State state() const override;
    void setState(const State& state) override;

    int threads() const;
    bool asleep(int body) const;
    /// Bytes held per tetrahedron, all bodies together.
    double bytesPerTetrahedron() const;

  private:
    struct Runner;
    struct BodyRun;
    const World& world_;
    std::int64_t step_ = 0;
    std::vector<std::unique_ptr<BodyRun>> bodies_;
    std::unique_ptr<Runner> runner_;
};

}  // namespace sunder
