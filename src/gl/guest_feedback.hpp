#pragma once
#include "gl/functions.hpp"

namespace sunder::gl {

/// A host's transform feedback, which may be going on: interrupted during a visit. Sunder's passes
/// have objects of their own for it.
class HostFeedback {
  public:
    void save();
    void interrupt();
    void goOn();

  private:
    GLuint object_ = 0, buffer_ = 0;
    bool interrupted_ = false;
};

}  // namespace sunder::gl
