#include "core/body_book.hpp"

#include <algorithm>

#include "core/archive.hpp"

namespace sunder::core {

BodyBook::BodyBook(const World& world)
    : world_(world),
      present_(world.bodies().size(), true),
      held_(world.bodies().size(), true),
      released_(world.bodies().size(), false),
      sleepers_(memberOfObject(world, static_cast<int>(world.objects().size()))) {}

bool BodyBook::holdsAny() const {
    return std::find(held_.begin(), held_.end(), true) != held_.end();
}

template <class Choice>
std::vector<int> BodyBook::chosen(const Choice& choice) const {
    std::vector<int> bodies;
    for (int body = 0; body < static_cast<int>(present_.size()); ++body)
        if (choice(body)) bodies.push_back(body);
    return bodies;
}

std::vector<int> BodyBook::absent() const {
    return chosen([this](int body) { return !present(body); });
}

std::vector<int> BodyBook::released() const {
    return chosen([this](int body) { return released(body); });
}

std::vector<int> BodyBook::activeBodies() const {
    return chosen([this](int body) { return active(body); });
}

std::vector<int> BodyBook::awakeBodies() const {
    return chosen([this](int body) { return awake(body); });
}

bool BodyBook::releaseAnchors(int body) {
    if (!present(body) || released(body) || world_.description().bodies[body].anchors.empty())
        return false;
    return released_[body] = true;
}

void BodyBook::follow(const State& state) {
    present_.assign(present_.size(), true);
    for (const int body : state.absent) present_[body] = false;
    released_.assign(released_.size(), false);
    for (const int body : state.released) released_[body] = true;
}

void BodyBook::describe(State& state) const {
    state.absent = absent();
    state.released = released();
}

BodyBook::Members BodyBook::split(const std::vector<int>& members) const {
    Members split;
    for (const int member : members)
        if (const int object = member - memberOfObject(world_, 0); object >= 0)
            split.objects.push_back(object);
        else
            split.bodies.push_back(member);
    return split;
}

BodyBook::Members BodyBook::wake(int member) {
    return split(sleepers_.wake(member));
}

BodyBook::Members BodyBook::wakeAround(int body, const std::vector<RestBox>& own,
                                       const AddBoxes& addBoxes,
                                       const std::vector<ObjectState>& objects) {
    std::vector<RestBox> others;
    addBoxes(others);
    std::erase_if(others, [&](const RestBox& box) { return box.member == memberOfBody(body); });
    for (int object = 0; object < static_cast<int>(objects.size()); ++object)
        if (objectAsleep(object)) others.push_back(restBoxOf(world_, object, objects[object]));
    std::vector<int> woken = sleepers_.wake(memberOfBody(body));
    for (const int member : membersNear(own, others)) {
        const std::vector<int> more = sleepers_.wake(member);
        woken.insert(woken.end(), more.begin(), more.end());
    }
    std::sort(woken.begin(), woken.end());
    return split(woken);
}

BodyBook::Members BodyBook::settle(const std::function<bool(int body)>& ready,
                                   const AddBoxes& addBoxes,
                                   const std::function<RestIslands::Status(int object)>& ofObject,
                                   const std::vector<ObjectState>& objects) {
    using Status = RestIslands::Status;
    std::vector<Status> status;
    for (int body = 0; body < static_cast<int>(present_.size()); ++body)
        status.push_back(!active(body)  ? Status::Apart
                         : asleep(body) ? Status::Asleep
                         : ready(body)  ? Status::Ready
                                        : Status::Restless);
    for (int object = 0; object < static_cast<int>(objects.size()); ++object)
        status.push_back(ofObject(object));
    return split(settleTouching(sleepers_, world_, status, addBoxes, objects));
}

std::vector<bool> BodyBook::archiveBodies(Archive& archive) {
    State now;
    describe(now);
    core::archiveBodies(archive, world_, now.absent, now.released);
    if (archive.reads()) follow(now);
    std::vector<bool> active = held_;
    for (const int body : now.absent) active[body] = false;
    return active;
}

void BodyBook::archiveSleepers(Archive& archive, const std::vector<bool>& active) {
    sleepers_.archive(archive, [&](int member) {
        const int object = member - memberOfObject(world_, 0);
        return object < 0 ? active[member] : world_.objects()[object].inverseMass > 0;
    });
}

}  // namespace sunder::core
