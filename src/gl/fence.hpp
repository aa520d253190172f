#pragma once
#include "gl/functions.hpp"

#include <memory>
#include <type_traits>

namespace sunder::gl {

/// A point in the stream of GL commands that can be waited for.
class Fence {
  public:
    Fence() = default;  ///< nothing to wait for
    static Fence insert();
    /// Returns once the GPU has passed it.
    void wait() const;

  private:
    struct Delete {
        void operator()(GLsync sync) const;
    };
    std::unique_ptr<std::remove_pointer_t<GLsync>, Delete> sync_;
};

}  // namespace sunder::gl
