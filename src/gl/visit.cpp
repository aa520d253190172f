#include "gl/visit.hpp"

#include "core/types.hpp"
#include "gl/timer.hpp"

namespace sunder::gl {

using namespace core;

Visit::Visit(Driver& driver, State state, Work work)
    : driver_(driver),
      before_(Driver::current()),
      state_(state),
      work_(work),
      nested_(driver.visited_) {
    if (nested_) return;
    if (driver_.gone_) {
        if (work_ == Work::Any)
            throw DeviceError("the host's OpenGL context has been destroyed; make a new device");
        // Where no driver is current, objects are let go without a call.
        state_ = State::Ours;
        Driver::setCurrent(nullptr);
        driver_.visited_ = true;
        return;
    }
    driver_.makeCurrent();
    try {
        enter();
    } catch (...) {
        Driver::setCurrent(before_);
        throw;
    }
    driver_.visited_ = true;
}

void Visit::enter() {
    if (state_ == State::Ours) return;
    if (!driver_.state_) driver_.state_ = std::make_unique<GuestState>(driver_);
    GuestState& host = *driver_.state_;
    if (driver_.asksErrors()) driver_.noteErrorsBefore();
    if (state_ == State::Dirty) {
        host.neutraliseAll();
        driver_.touched.begin(TouchedBindings::Mode::Cleared);
        return;
    }
    if (work_ == Work::Any) {
        host.refuseWhatCannotBeLeft();
        if (driver_.asksErrors()) refuseConditionalRendering();
    }
    host.save();
    host.neutralise();
    driver_.touched.begin(TouchedBindings::Mode::Noted);
}

/// Only one can be active, and there is nothing to ask but whether another one may begin.
void Visit::refuseConditionalRendering() const {
    const Query query = makeQuery();
    glBeginQuery(GL_ANY_SAMPLES_PASSED, query.id());
    glEndQuery(GL_ANY_SAMPLES_PASSED);
    glBeginConditionalRender(query.id(), GL_QUERY_NO_WAIT);
    if (glGetError() != GL_NO_ERROR)
        throw InputError(
            "conditional rendering is active in the host's OpenGL context; end it before Sunder "
            "is called");
    glEndConditionalRender();
}

Visit::~Visit() {
    if (nested_) return;
    if (state_ != State::Ours) driver_.touched.end();
    if (state_ == State::Restored) driver_.state_->restore();
    if (driver_.asksErrors() && !driver_.gone_) driver_.drain();
    driver_.visited_ = false;
    Driver::setCurrent(before_);
}

}  // namespace sunder::gl
