#include "core/rest_islands.hpp"

#include <algorithm>
#include <numeric>

#include "core/archive.hpp"
#include "core/object_contact.hpp"

namespace sunder::core {
namespace {

/// Sets that grow together (union–find with path halving).
class Sets {
  public:
    explicit Sets(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
    int find(int i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(int a, int b) { parent_[find(a)] = find(b); }

  private:
    std::vector<int> parent_;
};

/// Of its smallest half edge: surfaces of objects so near each other count as touching, which is
/// what a load presses them into each other and more.
constexpr double kObjectReach = 0.05;

double restReach(const Object& object) {
    return kObjectReach * (object.core.minCoeff() + object.radius);
}

bool objectsTouch(const World& world, int a, int b, const std::vector<ObjectState>& states) {
    const Object &first = world.objects()[a], &second = world.objects()[b];
    // Between two boxes, touchOf() may overestimate a gap; they touch where what surrounds them
    // does.
    if (!first.core.isZero() && !second.core.isZero()) return true;
    const Touch touch = touchOf(boxOf(first, states[a]), boxOf(second, states[b]));
    return touch.gap <= restReach(first) + restReach(second);
}

}  // namespace

std::vector<int> RestIslands::settle(const std::vector<Status>& status, const Touches& touches) {
    const auto count = static_cast<int>(status.size());
    const auto awake = [&](int i) {
        return status[i] == Status::Ready || status[i] == Status::Restless;
    };
    Sets sets(count);
    for (const auto& [a, b] : touches)
        if (awake(a) && awake(b)) sets.join(a, b);
    std::vector<bool> restless(count, false);
    for (int i = 0; i < count; ++i)
        if (status[i] == Status::Restless) restless[sets.find(i)] = true;
    std::vector<int> falling;
    std::vector<bool> falls(count, false);
    for (int i = 0; i < count; ++i) {
        if (status[i] != Status::Ready || restless[sets.find(i)]) continue;
        falling.push_back(i);
        falls[i] = true;
        island_[i] = next_ + sets.find(i);
    }
    if (falling.empty()) return falling;
    next_ += count;
    for (const auto& [a, b] : touches) {
        const bool joins = (falls[a] && (falls[b] || status[b] == Status::Asleep)) ||
                           (falls[b] && status[a] == Status::Asleep);
        if (!joins || island_[a] == island_[b]) continue;
        std::replace(island_.begin(), island_.end(), int{island_[a]}, int{island_[b]});
    }
    return falling;
}

std::vector<int> RestIslands::wake(int member) {
    std::vector<int> woken;
    const int island = island_[member];
    if (island == kAwake) return woken;
    for (int i = 0; i < static_cast<int>(island_.size()); ++i) {
        if (island_[i] != island) continue;
        island_[i] = kAwake;
        woken.push_back(i);
    }
    return woken;
}

void RestIslands::archive(Archive& a, const std::function<bool(int member)>& maySleep) {
    a.section("sleepers");
    RestIslands now = *this;
    now.next_ = a.whole(next_, 0, 1 << 30);
    for (int member = 0; member < static_cast<int>(island_.size()); ++member) {
        int& island = now.island_[member];
        island = a.whole(island, kAwake, std::max(0, now.next_ - 1));
        a.require(island == kAwake || maySleep(member));
    }
    if (a.reads()) *this = std::move(now);
}

double restReach(const Body& body) {
    return 0.1 * body.cellSize.minCoeff();
}

RestBox restBoxOf(const World& world, int index, const ObjectState& state) {
    const Object& object = world.objects()[index];
    const RoundedBox box = boxOf(object, state);
    const Vec3 half =
        box.axes.cwiseAbs() * box.half + Vec3::Constant(object.radius + restReach(object));
    return {memberOfObject(world, index), box.centre - half, box.centre + half};
}

RestIslands::Touches restTouches(const World& world, std::vector<RestBox> boxes,
                                 const std::vector<ObjectState>& objects) {
    std::sort(boxes.begin(), boxes.end(),
              [](const RestBox& a, const RestBox& b) { return a.low[0] < b.low[0]; });
    const auto bodies = static_cast<int>(world.bodies().size());
    RestIslands::Touches touches;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size() && boxes[j].low[0] <= boxes[i].high[0]; ++j) {
            const RestBox &a = boxes[i], &b = boxes[j];
            if (a.member == b.member) continue;
            if ((a.low.array() > b.high.array()).any() || (b.low.array() > a.high.array()).any())
                continue;
            const auto [low, high] = std::minmax(a.member, b.member);
            if (low >= bodies && !objectsTouch(world, low - bodies, high - bodies, objects))
                continue;
            touches.emplace_back(low, high);
        }
    std::sort(touches.begin(), touches.end());
    touches.erase(std::unique(touches.begin(), touches.end()), touches.end());
    return touches;
}

std::vector<int> membersNear(const std::vector<RestBox>& own, const std::vector<RestBox>& boxes) {
    std::vector<int> members;
    for (const RestBox& box : boxes) {
        if (!members.empty() && members.back() == box.member) continue;
        const bool near = std::any_of(own.begin(), own.end(), [&](const RestBox& mine) {
            return (mine.low.array() <= box.high.array()).all() &&
                   (box.low.array() <= mine.high.array()).all();
        });
        if (near) members.push_back(box.member);
    }
    return members;
}

std::vector<int> settleTouching(RestIslands& islands, const World& world,
                                const std::vector<RestIslands::Status>& status,
                                const std::function<void(std::vector<RestBox>&)>& addBodyBoxes,
                                const std::vector<ObjectState>& objects) {
    using Status = RestIslands::Status;
    if (std::count(status.begin(), status.end(), Status::Ready) == 0) return {};
    std::vector<RestBox> boxes;
    addBodyBoxes(boxes);
    for (int object = 0; object < static_cast<int>(objects.size()); ++object)
        if (status[memberOfObject(world, object)] != Status::Apart)
            boxes.push_back(restBoxOf(world, object, objects[object]));
    return islands.settle(status, restTouches(world, std::move(boxes), objects));
}

}  // namespace sunder::core
