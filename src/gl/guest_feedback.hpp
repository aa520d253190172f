#pragma once
#include "gl/functions.hpp"

namespace sunder::gl {

class Driver;

/// A host's transform feedback, which may be going on: interrupted during a visit.
class HostFeedback {
  public:
    void save();
    void interrupt(Driver&);
    void goOn(Driver&);

  private:
    GLuint object_ = 0, buffer_ = 0;
    bool interrupted_ = false;
};

}  // namespace sunder::gl
