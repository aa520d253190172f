#include "gl/guest_feedback.hpp"

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

void HostFeedback::interrupt() {
    if (interrupted_) glPauseTransformFeedback();
}

void HostFeedback::goOn() {
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, object_);
    // Some drivers count the buffer to the object and so have brought it back, others to the
    // context.
    if (boundName(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING) != buffer_)
        glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer_);
    if (interrupted_) glResumeTransformFeedback();
}

}  // namespace sunder::gl
