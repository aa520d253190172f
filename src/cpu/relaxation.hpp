#pragma once
#include <functional>
#include <vector>

#include "core/standing.hpp"
#include "cpu/threads.hpp"

namespace sunder::cpu {

/// The search for the state of rest of a group of things that stand: dynamic relaxation with
/// kinetic damping (Cundall 1976; Barnes 1999) on a copy of the group in which nothing breaks.
/// Whenever its kinetic energy has passed a maximum it is near equilibrium, and is stopped. The
/// copy is advanced by CpuSolver, so that contact, barriers and large deformations are the
/// simulation's own.
class Relaxation {
  public:
    enum class Outcome {
        Rest,
        Toppled,    ///< something moves as a whole: it has no equilibrium where it stands
        OutOfSteps  ///< what was reached, if it got near equilibrium at all, is in the state
    };

    /// `world` and `group` must outlive it.
    Relaxation(const core::World& world, const core::StandingGroup& group, const Threads& threads);

    /// Writes displacements of the group's bodies, the static tractions of their bonds and the
    /// places of its objects into `state`, which is the world's. `progress` hears the share of the
    /// steps that is done.
    Outcome run(core::State& state, int steps, const std::function<void(double)>& progress);

    /// What toppled, as indices into the world's bodies and objects.
    const core::StandingGroup& toppled() const { return toppled_; }

  private:
    /// Of the copy; its objects are the group's, then those that do not move.
    struct Shape {
        std::vector<core::Vec3> displacement;
        std::vector<core::ObjectState> objects;
    };
    class Damping;

    Outcome relax(const core::World& copy, core::State& state);
    double stepStretch() const;
    bool topples(const core::World& copy, const Shape& now);
    bool keepsShape(const core::World& copy, const Shape& before, const Shape& now,
                    int steps) const;
    bool keepsStress(const Shape& now, core::State& state) const;
    void write(const Shape& now, core::State& state) const;

    const core::World& world_;
    const core::StandingGroup& group_;
    Threads threads_;
    core::WorldDescription alone_;  ///< the copy's
    Shape reached_;
    int stepsLeft_ = 0, steps_ = 0;
    std::function<void(double)> progress_;
    core::StandingGroup toppled_;
};

}  // namespace sunder::cpu
