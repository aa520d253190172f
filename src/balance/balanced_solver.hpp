#pragma once
#include "balance/load_balancer.hpp"
#include "cpu/cpu_solver.hpp"
#include "gpu/gather.hpp"

namespace sunder::balance {

/// `auto`: every body runs on `cpu` or on `gather`, both at the same time, shared out by measured
/// cost (LoadBalancer); a body moves from one to the other between frames with its state intact.
/// With contact all of them move together, for they may touch each other: the faster of the two has
/// them. The GPU works while the CPU does; only frames that are measured wait for both. The result
/// depends on who advanced what when, and so on the machine: the two differ in rounding.
///
/// Needs a current GL context for as long as it lives.
class BalancedSolver : public gpu::GpuSolver {
  public:
    /// Throws InputError when the world is too large for the device. `world` and `buffers` must
    /// outlive it. threads: of `cpu`.
    BalancedSolver(const core::World& world, const gpu::WorldBuffers& buffers,
                   const cpu::Threads& threads = {});

    std::string_view name() const override { return "auto"; }
    void advance(int steps) override;
    void finish() override { gather_.finish(); }
    core::State state() const override;
    std::unique_ptr<core::StateCopy> makeStateCopy() const override;
    void setState(const core::State& state) override;
    /// The state alone, as setState() takes it: who has what and how fast is this machine's own.
    void archive(core::Archive& archive) override;
    void push(const core::Event& event) override {
        gather_.push(event);
        cpu_.push(event);
    }
    void putObject(int object, const core::ObjectState& state) override {
        // Objects are with the bodies, all of which one of the two has.
        if (onGpu(0))
            gather_.putObject(object, state);
        else
            cpu_.putObject(object, state);
    }
    void setPresent(int body, bool present) override {
        gather_.setPresent(body, present);
        cpu_.setPresent(body, present);
    }
    bool present(int body) const override { return cpu_.present(body); }
    void releaseAnchors(int body) override {
        gather_.releaseAnchors(body);
        cpu_.releaseAnchors(body);
    }
    bool released(int body) const override { return cpu_.released(body); }
    bool asleep(int body) const override;
    bool objectAsleep(int object) const override;
    /// Of the bodies on the GPU; `cpu` has room for all.
    std::int64_t droppedContacts() const override { return gather_.droppedContacts(); }
    std::vector<double> contactHaste() const override { return gather_.contactHaste(); }
    gpu::StateView view() override;
    /// Of the bodies on the GPU.
    void setPassTimer(gpu::PassTimer* timer) override { gather_.setPassTimer(timer); }
    void setIncidents(core::IncidentRing* ring) override {
        gather_.setIncidents(ring);
        cpu_.setIncidents(ring);
    }
    /// Its parts run at the same time.
    bool setPassObserver(core::PassObserver*) override { return false; }

    bool onGpu(int body) const { return gather_.holds(body); }
    std::optional<int> bodiesOnGpu() const override;
    bool settled() const override { return balancer_.settled(); }

  private:
    class LateState;
    /// What the CPU has, into a state of the GPU.
    void addCpu(core::State& state) const;
    void moveBodies();
    bool wantedOnGpu(int body) const;

    const core::World& world_;
    gpu::GatherSolver gather_;
    cpu::CpuSolver cpu_;
    LoadBalancer balancer_;
    core::State scratch_;  ///< what bodies pass through on their way
};

}  // namespace sunder::balance
