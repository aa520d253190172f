#pragma once
#include <bit>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/diagnostics.hpp"
#include "core/incident.hpp"
#include "gl/visit.hpp"
#include "gpu/gather.hpp"
#include "gpu/scatter.hpp"
#include "window/context.hpp"

/// A wall that breaks, slabs with cells of another size on it, a ball that hits them: every pass of
/// every solver has something to do.
const sunder::core::World& guestWorld();

/// A solver in a host's context. Every call is a visit of its own.
template <class Solver>
class Guest {
  public:
    explicit Guest(sunder::gl::Driver& driver, const sunder::core::World& world = guestWorld(),
                   sunder::gl::Visit::State state = sunder::gl::Visit::State::Restored)
        : driver_(driver), world_(world), state_(state) {
        const sunder::gl::Visit visit(driver_, state_);
        buffers_.emplace(world_);
        solver_.emplace(world_, *buffers_);
        solver_->setIncidents(&incidents_);
    }
    ~Guest() {
        const sunder::gl::Visit visit(driver_, state_, sunder::gl::Visit::Work::Deletes);
        solver_.reset();
        buffers_.reset();
    }
    Guest(const Guest&) = delete;
    Guest& operator=(const Guest&) = delete;

    void restart() {
        const sunder::gl::Visit visit(driver_, state_);
        solver_->setState(world_.initialState());
    }
    void advance(int steps) {
        const sunder::gl::Visit visit(driver_, state_);
        solver_->advance(steps);
    }
    sunder::core::State state() {
        const sunder::gl::Visit visit(driver_, state_);
        solver_->finish();
        return solver_->state();
    }
    std::vector<sunder::core::Incident> incidents() {
        const sunder::gl::Visit visit(driver_, state_);
        solver_->finish();
        return incidents_.take();
    }
    /// Of the state, damage and all, and of the incidents so far.
    std::uint64_t hash() {
        const sunder::core::State now = state();
        std::uint64_t sum = stateHash(now);
        const auto add = [&](double value) {
            sum = (sum ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u;
            sum ^= sum >> 29;
        };
        for (const double damage : now.damage) add(damage);
        for (const double slow : now.slow) add(slow);
        for (const sunder::core::Incident& incident : incidents_.take()) add(incident.impulse);
        return sum;
    }

  private:
    sunder::gl::Driver& driver_;
    const sunder::core::World& world_;
    sunder::gl::Visit::State state_;
    sunder::core::IncidentRing incidents_{1024};
    std::optional<sunder::gpu::WorldBuffers> buffers_;
    std::optional<Solver> solver_;
};

/// Steps, four looks of them, in pieces that no interval of the solvers divides.
inline constexpr int kPieces[] = {7, 13, 1, 19};

/// What a solver makes of the world where nobody else uses the context.
template <class Solver>
std::uint64_t hashOf(Guest<Solver>& guest) {
    for (const int steps : kPieces) guest.advance(steps);
    return guest.hash();
}
