#include "gl/fence.hpp"

#include "gl/driver.hpp"

namespace sunder::gl {

void Fence::Delete::operator()(GLsync sync) const {
    if (Driver::current()) glDeleteSync(sync);
}

Fence Fence::insert() {
    Fence fence;
    fence.sync_.reset(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
    return fence;
}

void Fence::wait() const {
    if (!sync_) return;
    constexpr GLuint64 second = 1'000'000'000;  // ns
    while (glClientWaitSync(sync_.get(), GL_SYNC_FLUSH_COMMANDS_BIT, second) ==
           GL_TIMEOUT_EXPIRED) {
    }
}

}  // namespace sunder::gl
