#include "gl/guest_feedback.hpp"

#include "gl/driver.hpp"

namespace sunder::gl {
namespace {

bool isSet(GLenum name) {
    GLboolean value = GL_FALSE;
    glGetBooleanv(name, &value);
    return value != GL_FALSE;
}

}  // namespace

void HostFeedback::save() {
    object_ = boundName(GL_TRANSFORM_FEEDBACK_BINDING);
    buffer_ = boundName(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING);
    interrupted_ =
        isSet(GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE) && !isSet(GL_TRANSFORM_FEEDBACK_BUFFER_PAUSED);
}

// While an active object is bound, even a paused one, programs cannot be given what they capture.
// Object 0 may be active, too, whether or not it is the one that is bound.
void HostFeedback::interrupt(Driver& driver) {
    if (interrupted_) glPauseTransformFeedback();
    glGenTransformFeedbacks(1, &driver.idleFeedback);
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, driver.idleFeedback);
}

void HostFeedback::goOn(Driver& driver) {
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, object_);
    // Some drivers count the buffer to the object and so have brought it back, others to the
    // context.
    if (boundName(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING) != buffer_)
        glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer_);
    if (interrupted_) glResumeTransformFeedback();
    glDeleteTransformFeedbacks(1, &driver.idleFeedback);
    driver.idleFeedback = 0;
}

}  // namespace sunder::gl
