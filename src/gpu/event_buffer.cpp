#include "gpu/event_buffer.hpp"

#include <algorithm>

#include "gpu/layout.hpp"

namespace sunder::gpu {

using namespace core;

EventBuffer::EventBuffer(const World& world)
    : world_(world),
      buffer_(sizeof(EventRecord) * std::max<std::size_t>(1, world.events().size()), nullptr,
              GL_DYNAMIC_DRAW, "events"),
      texture_(gl::makeBufferTexture(buffer_, GL_RGBA32F, "events")) {}

bool EventBuffer::write(std::int64_t step, int steps) {
    std::vector<EventRecord> records;
    bool active = false;
    for (const Event& event : world_.events()) {
        const auto toFloat = [](double value) { return static_cast<float>(value); };
        const Vec3& a = event.acceleration;
        const double start = event.start - static_cast<double>(step),
                     end = event.end - static_cast<double>(step);
        active |= start < steps && end > 0;
        records.push_back({{event.point[0], event.point[1], event.point[2], event.radius},
                           {toFloat(a[0]), toFloat(a[1]), toFloat(a[2]), 0},
                           {toFloat(start), toFloat(end), 0, 0}});
    }
    // Once more after the last one ended, or it would act again.
    if (active || stale_) buffer_.write(0, sizeof(EventRecord) * records.size(), records.data());
    stale_ = active;
    return active;
}

}  // namespace sunder::gpu
