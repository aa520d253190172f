#pragma once
#include <functional>
#include <utility>
#include <vector>

#include "core/world.hpp"

namespace sunder::core {

class Archive;

/// Bodies and objects of a world in one numbering: its bodies, then its objects.
inline int memberOfBody(int body) {
    return body;
}
inline int memberOfObject(const World& world, int object) {
    return static_cast<int>(world.bodies().size()) + object;
}

/// What rests on what: members that touched when they fell asleep wake together (core/sleep.hpp).
class RestIslands {
  public:
    explicit RestIslands(int members) : island_(members, kAwake) {}

    enum class Status : std::uint8_t {
        Apart,     ///< not there, not held by the solver, or fixed: it joins nothing
        Restless,  ///< awake
        Ready,     ///< awake, and calm for long enough
        Asleep,
    };
    using Touches = std::vector<std::pair<int, int>>;
    /// Those ready members that now fall asleep, ascending: what they hang together with by
    /// `touches`, over other members that are awake, is ready, too. They join the islands of
    /// sleepers that they touch.
    std::vector<int> settle(const std::vector<Status>& status, const Touches& touches);
    /// Wakes a member: those that sleep with it, ascending, itself among them; none where it is
    /// awake.
    std::vector<int> wake(int member);
    /// maySleep(member): whether it may be asleep.
    void archive(Archive& archive, const std::function<bool(int member)>& maySleep);
    void wakeAll() { island_.assign(island_.size(), kAwake); }
    bool asleep(int member) const { return island_[member] != kAwake; }

  private:
    static constexpr int kAwake = -1;
    std::vector<int> island_;  ///< of those asleep: the same number for those that wake together
    int next_ = 0;
};

/// A box around a few cells in a row, or around an object, and as much more as counts as touching.
struct RestBox {
    int member;
    Vec3 low, high;  ///< m
};
/// Cells of one body in the order of their numbers that share a box.
inline constexpr int kCellsPerRestBox = 16;
/// m: boxes of a body's cells reach so far beyond their nodes. A contact's spheres stand out of a
/// cell that is pressed flat by a tenth of an edge.
double restReach(const Body& body);
RestBox restBoxOf(const World& world, int object, const ObjectState& state);

/// Members with boxes that meet any of a body's own.
std::vector<int> membersNear(const std::vector<RestBox>& own, const std::vector<RestBox>& boxes);

/// RestIslands::settle(), with what touches found out where somebody is ready. addBodyBoxes: adds
/// the boxes of the bodies that are not Apart.
std::vector<int> settleTouching(RestIslands& islands, const World& world,
                                const std::vector<RestIslands::Status>& status,
                                const std::function<void(std::vector<RestBox>&)>& addBodyBoxes,
                                const std::vector<ObjectState>& objects);

/// Pairs of members some of whose boxes meet, each once. A ball meets an object where their
/// surfaces do.
RestIslands::Touches restTouches(const World& world, std::vector<RestBox> boxes,
                                 const std::vector<ObjectState>& objects);

}  // namespace sunder::core
