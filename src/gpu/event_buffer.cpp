#include "gpu/event_buffer.hpp"

#include <vector>

#include "gpu/layout.hpp"

namespace sunder::gpu {

using namespace core;

EventBuffer::EventBuffer(const World& world) : schedule_(world), bodies_(world.bodies().size()) {
    reserve(1 + bodies_);
}

void EventBuffer::reserve(std::size_t texels) {
    if (buffer_.size() >= texels * sizeof(vec4)) return;
    // Once more as much, or every frame with one more event than ever would need a new one.
    buffer_ = gl::Buffer(2 * texels * sizeof(vec4), nullptr, GL_DYNAMIC_DRAW, "events");
    texture_ = gl::makeBufferTexture(buffer_, GL_RGBA32F, "events");
}

bool EventBuffer::write(std::int64_t step, int steps) {
    // What acts within these steps, those of every body first.
    static_assert(kEveryBody == -1);
    std::vector<std::vector<const Event*>> active(1 + bodies_);
    std::size_t count = 0;
    for (const Event& event : schedule_.all()) {
        if (event.nextStep(step) >= step + steps) continue;
        active[static_cast<std::size_t>(1 + event.body)].push_back(&event);
        ++count;
    }
    // Once more after the last one ended, or it would act again.
    if (count > 0 || stale_) upload(active, step);
    stale_ = count > 0;
    return count > 0;
}

void EventBuffer::upload(const std::vector<std::vector<const Event*>>& active, std::int64_t step) {
    std::vector<vec4> texels(active.size());
    for (std::size_t i = 0; i < active.size(); ++i) {
        texels[i] =
            vec4(static_cast<float>(texels.size()), static_cast<float>(active[i].size()), 0, 0);
        for (const Event* event : active[i]) {
            const double start = event->start - static_cast<double>(step),
                         end = event->end - static_cast<double>(step);
            texels.push_back({event->point[0], event->point[1], event->point[2], event->radius});
            texels.push_back(toVec4(event->acceleration, event->outward));
            texels.push_back({static_cast<float>(start), static_cast<float>(end),
                              event->falloff ? 1.f : 0.f, 0});
        }
    }
    reserve(texels.size());
    buffer_.write(0, texels.size() * sizeof(vec4), texels.data());
}

}  // namespace sunder::gpu
