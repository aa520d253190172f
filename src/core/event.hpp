#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/object.hpp"
#include "core/types.hpp"

namespace sunder::core {

class Archive;
class World;

/// An event that pushes what its ball holds of every body and of objects.
inline constexpr int kEveryBody = -1;

/// A push: an acceleration of the nodes in a ball, for a while. An event of one body picks them by
/// where they are at rest, so that the same patch is pushed to its end, however it moves; one of
/// every body by where they are in each step, and objects as src/cpu/object_push.hpp says.
struct Event {
    int body = 0;                    ///< index, or kEveryBody
    Eigen::Vector3f point{0, 0, 0};  ///< m, world; single precision so that every solver picks the
                                     ///< same nodes at rest
    float radius = 0;                ///< m
    Vec3 acceleration{0, 0, 0};      ///< m/s²
    double outward = 0;         ///< m/s², away from the point, on top of it; only of kEveryBody
    bool falloff = false;       ///< times 1 − d²/radius² at distance d; only of kEveryBody
    double start = 0, end = 0;  ///< in steps, fractions count

    /// Share of step number `step` that lies inside [start, end], 0 to 1.
    double weight(std::int64_t step) const;
    /// Whether it acts in no step from `step` on.
    bool hasEnded(std::int64_t step) const { return end <= static_cast<double>(step); }
    /// The first step from `from` on that it acts in; the largest number there is where it does in
    /// none.
    std::int64_t nextStep(std::int64_t from) const;
    /// m/s²: of what is at `place` (m, world), for an event of every body; zero outside the ball.
    Vec3 accelerationAt(const Vec3& place) const;
    /// Whether the ball reaches into a box, m.
    bool reaches(const Vec3& low, const Vec3& high) const;
};

/// Whether a node is in the patch of an event of one body. The same single-precision operations in
/// the same order as glsl/physics/events.glsl.
bool insidePatch(const Event&, const Eigen::Vector3f& rest);

/// An event of every body at work in a step.
struct Blast {
    const Event* event;
    double weight;  ///< Event::weight()
};
/// m/s²: of what is at `place` (m, world), by all of them.
Vec3 accelerationAt(const Vec3& place, std::span<const Blast> blasts);

/// The events that a solver plays: its world's, and those it was given while time ran.
class EventSchedule {
  public:
    /// `world` must outlive it.
    explicit EventSchedule(const World& world);

    /// Adds one that comes after all others. Those that ended long before step `now`, and were
    /// added like this, are forgotten.
    void add(const Event& event, std::int64_t now);
    /// These instead of all that were added.
    void setAdded(const std::vector<Event>& events);
    /// Added ones that have not ended by `now`, in the order in which they came.
    std::vector<Event> added(std::int64_t now) const;

    /// Those that were added, as far as a solver at step `now` may ask for them.
    void archive(Archive& archive, std::int64_t now);

    /// In the order in which they add up: the world's by body and as described, then the others.
    const std::vector<Event>& all() const { return events_; }

    /// Those of every body, likewise, as indices into all().
    const std::vector<int>& blasts() const { return blasts_; }
    /// The first step from `from` on that an event of this one body acts in; the largest number
    /// there is where none does. Events of every body do not count.
    std::int64_t nextPush(int body, std::int64_t from) const;
    /// Whether one does within steps from .. to − 1.
    bool pushedWithin(int body, std::int64_t from, std::int64_t to) const {
        return nextPush(body, from) < to;
    }
    /// The same of events of every body.
    std::int64_t nextBlast(std::int64_t from) const;
    /// Those at work in a step; valid until another event is added.
    std::vector<Blast> blastsAt(std::int64_t step) const;
    /// Whether one reaches into a box, m, within steps from .. to − 1.
    bool blastWithin(std::int64_t from, std::int64_t to, const Vec3& low, const Vec3& high) const;

  private:
    void list(int index);
    std::int64_t next(const std::vector<int>& events, std::int64_t from) const;

    const World& world_;
    std::vector<Event> events_;
    std::size_t ofWorld_;  ///< how many of them are the world's
    std::vector<std::vector<int>> byBody_;
    std::vector<int> blasts_;
    std::int64_t memory_;       ///< steps for which what has ended is kept
    std::size_t sweepAt_ = 64;  ///< what has ended is looked for when there are so many
};

/// An object that is thrown as step number `step` begins.
struct Throw {
    std::int64_t step = 0;
    int object = 0;
    ObjectState state;
};

}  // namespace sunder::core
