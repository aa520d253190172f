#pragma once
#include "gl/functions.hpp"

#include <vector>

#include "gl/objects.hpp"

namespace sunder::gl {

void deleteQuery(GLuint);
using Query = Handle<deleteQuery>;
Query makeQuery();

/// Measures how long the GPU spends on stretches of its command stream (GL_TIME_ELAPSED). Stretches
/// do not nest, not even those of two timers. Nothing waits until take().
class Timer {
  public:
    void begin();
    void end();
    /// ms per stretch since the last call, oldest first. Waits for the GPU; never inside a frame.
    std::vector<double> take();

  private:
    std::vector<Query> queries_;  ///< the first used_ of them have been started
    std::size_t used_ = 0;
};

}  // namespace sunder::gl
