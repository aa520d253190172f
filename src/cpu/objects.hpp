#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/archive.hpp"
#include "core/incident_watch.hpp"
#include "core/object_contact.hpp"
#include "core/rest_islands.hpp"
#include "core/room.hpp"
#include "core/sleep.hpp"
#include "core/world.hpp"

namespace sunder::cpu {

/// The world's objects (core/object_contact.hpp) for the solvers on the CPU: what they push, what
/// pushes them, how they move.
class Objects {
  public:
    /// A solver's nodes.
    class Cells {
      public:
        virtual ~Cells() = default;
        struct Bounds {
            core::Vec3 low, high;  ///< m
        };
        /// Around all nodes of a body, and where they get within World::contactInterval() steps.
        virtual Bounds bounds(int body) const = 0;
        virtual core::CellMotion motion(int cell) const = 0;
        /// linkMask() of one of its corners.
        virtual std::uint8_t links(int cell, int corner) const = 0;
        /// Adds weights[corner]·force (N) to the forces on a cell's corners.
        virtual void push(int cell, const std::array<double, core::kCorners>& weights,
                          const core::Vec3& force) = 0;
    };

    explicit Objects(const core::World& world);

    const std::vector<core::ObjectState>& states() const { return states_; }
    /// All of them are awake.
    void set(const std::vector<core::ObjectState>& states);
    void set(int object, const core::ObjectState& state);
    /// Their spins, too; wakes all of them.
    void scaleVelocities(double factor);
    /// Gets to know what is pushed; null: nobody does.
    void setWatch(core::IncidentWatch* watch) { watch_ = watch; }

    /// States, what the last search found, and how calm they are. All of them are awake then.
    void archive(core::Archive& archive);

    /// Objects that step number `step` begins with are thrown.
    void startStep(std::int64_t step);
    /// Gives those that are free to move what blasts add to their motion in the step that begins,
    /// before anything is found that they touch: they are to meet it as fast as they are then.
    void accelerate(std::span<const core::Blast> blasts);
    /// Finds the cells that objects may touch within World::contactInterval() steps, and what
    /// disturbs sleepers. `held`: bodies to look at.
    void search(const Cells& cells, const std::vector<bool>& held);
    bool searchDue() const { return searchDue_; }
    /// Whether the last search found something of the body.
    bool near(int body) const { return near_[body]; }
    /// Whether an object that moves may touch the body before the next search.
    bool hit(int body) const { return hit_[body]; }
    /// Whether a cell or an object that moves may touch this sleeping object before the next
    /// search.
    bool disturbed(int object) const { return disturbed_[object]; }

    /// Takes note of what each did since the last time, `steps` steps ago.
    void look(int steps);
    core::RestIslands::Status restStatus(int object) const;
    bool asleep(int object) const { return asleep_[object]; }
    void fallAsleep(int object);
    void wake(int object);
    /// Whether any moves, or may begin to.
    bool anyAwake() const;

    /// Pushes cells and objects apart, for the step in progress.
    void push(Cells& cells);
    /// Moves the objects to the end of the step. Forces must be known: push().
    void move();

  private:
    struct Candidate {
        int cell, object;
    };
    /// Two sides that touch in this step: an object, and a cell, an object or a
    /// barrier.
    struct Active {
        core::Touch touch;
        int object, cell, other;  ///< −1: not that
        core::Vec3 velocity;      ///< m/s, relative to the object
        double restitution, friction;
        core::Yield yield;  ///< of a cell
        std::array<double, core::kCorners> weights;
    };
    struct Impulse {
        core::TouchSum sum;
        core::Vec3 angular{0, 0, 0};  ///< N·m·s
    };
    struct Rest {
        core::ObjectUnrest unrest;
        int calmSteps = 0;
    };

    void findOf(int object, int body, const Cells& cells, const Cells::Bounds& bounds);
    void touchCell(const Candidate& candidate, const Cells& cells);
    void pushOut(core::Touch& touch, const core::RoundedBox& object, const core::RoundedBox& box,
                 int cell, const Cells& cells) const;
    void touchBarriers(int object);
    void touchObjects(int a, int b);
    /// Whether two are too far apart, and too slow, for any point of one to meet the other within
    /// the step: most pairs, at a hundredth of the cost of looking closer.
    bool outOfReach(int a, int b) const;
    void add(Active active);
    void apply(const Active& active, Cells& cells);
    void findDisturbed();
    void move(int object, const Impulse& given);
    /// Of a kinematic object.
    void carry(int object);
    double speed(int object) const { return speedOf(object, states_[object]); }
    /// m/s, of the farthest point at most.
    double speedOf(int object, const core::ObjectState& state) const;
    bool moves(int object) const { return speed(object) > core::kStirringSpeed; }
    /// It does not yield: fixed, or asleep.
    bool still(int object) const {
        return world_.objects()[object].inverseMass == 0 || asleep_[object];
    }
    core::Yield yield(int object, const core::Touch& touch) const;
    double share(int object) const {
        return core::loadShare(world_.objects()[object], states_[object]);
    }

    const core::World& world_;
    std::vector<core::ContactProxy> proxies_;  ///< per body
    std::vector<core::Barrier> barriers_;
    std::vector<core::ObjectState> states_;
    std::vector<Candidate> candidates_;     ///< by cell
    std::vector<bool> near_, hit_;          ///< per body
    std::vector<bool> disturbed_, asleep_;  ///< per object
    std::vector<Rest> rests_;
    double heaviest_;       ///< kg, of everything together
    double settlingSpeed_;  ///< m/s
    double gentlePush_;     ///< m/s, in a step: the last search covers it
    int sleepSteps_;
    std::vector<Active> active_;
    std::vector<int> cellTouches_;    ///< N, per candidate's cell, 0 between steps
    std::vector<int> objectTouches_;  ///< K
    std::vector<Impulse> impulses_;
    core::IncidentWatch* watch_ = nullptr;
    bool searchDue_ = true;
};

}  // namespace sunder::cpu
