#include "core/event.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/archive.hpp"
#include "core/sleep.hpp"
#include "core/world.hpp"

namespace sunder::core {

double Event::weight(std::int64_t step) const {
    const auto begin = static_cast<double>(step);
    return std::clamp(std::min(end, begin + 1) - std::max(start, begin), 0.0, 1.0);
}

std::int64_t Event::nextStep(std::int64_t from) const {
    if (hasEnded(from)) return std::numeric_limits<std::int64_t>::max();
    return std::max(from, static_cast<std::int64_t>(std::floor(start)));
}

Vec3 Event::accelerationAt(const Vec3& place) const {
    const Vec3 away = place - point.cast<double>();
    const double distance2 = away.squaredNorm(), reach2 = double(radius) * radius;
    if (distance2 >= reach2) return Vec3::Zero();
    Vec3 result = acceleration;
    if (distance2 > 0) result += outward / std::sqrt(distance2) * away;
    return falloff ? Vec3((1 - distance2 / reach2) * result) : result;
}

bool Event::reaches(const Vec3& low, const Vec3& high) const {
    const Vec3 centre = point.cast<double>();
    return (centre - centre.cwiseMax(low).cwiseMin(high)).norm() <= radius;
}

Vec3 accelerationAt(const Vec3& place, std::span<const Blast> blasts) {
    Vec3 sum = Vec3::Zero();
    for (const Blast& blast : blasts) sum += blast.weight * blast.event->accelerationAt(place);
    return sum;
}

bool insidePatch(const Event& event, const Eigen::Vector3f& rest) {
    const float x = rest[0] - event.point[0], y = rest[1] - event.point[1],
                z = rest[2] - event.point[2];
    return x * x + y * y + z * z <= event.radius * event.radius;
}

EventSchedule::EventSchedule(const World& world)
    : world_(world),
      events_(world.events()),
      ofWorld_(world.events().size()),
      byBody_(world.bodies().size()),
      memory_(sleepSteps(world)) {
    setAdded({});
}

void EventSchedule::add(const Event& event, std::int64_t now) {
    events_.push_back(event);
    list(static_cast<int>(events_.size()) - 1);
    if (events_.size() - ofWorld_ < sweepAt_) return;
    setAdded(added(now - memory_));
    sweepAt_ = 2 * (events_.size() - ofWorld_) + 64;
}

void EventSchedule::setAdded(const std::vector<Event>& events) {
    events_.resize(ofWorld_);
    events_.insert(events_.end(), events.begin(), events.end());
    for (std::vector<int>& own : byBody_) own.clear();
    blasts_.clear();
    for (int i = 0; i < static_cast<int>(events_.size()); ++i) list(i);
}

void EventSchedule::list(int index) {
    const int body = events_[index].body;
    (body == kEveryBody ? blasts_ : byBody_[body]).push_back(index);
}

std::vector<Event> EventSchedule::added(std::int64_t now) const {
    std::vector<Event> later;
    std::copy_if(events_.begin() + static_cast<std::ptrdiff_t>(ofWorld_), events_.end(),
                 std::back_inserter(later),
                 [now](const Event& event) { return !event.hasEnded(now); });
    return later;
}

void EventSchedule::archive(Archive& a, std::int64_t now) {
    a.section("pushes");
    std::vector<Event> events = a.writes() ? added(now - memory_) : std::vector<Event>();
    a.list(events, kMaxPushes, [&](Event& event) { core::archive(a, world_, event); });
    if (a.reads()) setAdded(events);
}

std::int64_t EventSchedule::nextPush(int body, std::int64_t from) const {
    return next(byBody_[body], from);
}

std::int64_t EventSchedule::nextBlast(std::int64_t from) const {
    return next(blasts_, from);
}

std::vector<Blast> EventSchedule::blastsAt(std::int64_t step) const {
    std::vector<Blast> result;
    for (const int index : blasts_)
        if (const double weight = events_[index].weight(step); weight > 0)
            result.push_back({&events_[index], weight});
    return result;
}

bool EventSchedule::blastWithin(std::int64_t from, std::int64_t to, const Vec3& low,
                                const Vec3& high) const {
    return std::any_of(blasts_.begin(), blasts_.end(), [&](int index) {
        return events_[index].nextStep(from) < to && events_[index].reaches(low, high);
    });
}

std::int64_t EventSchedule::next(const std::vector<int>& events, std::int64_t from) const {
    std::int64_t next = std::numeric_limits<std::int64_t>::max();
    for (const int index : events) next = std::min(next, events_[index].nextStep(from));
    return next;
}

}  // namespace sunder::core
