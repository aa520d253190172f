#pragma once
#include "gl/functions.hpp"

/// Counts what is made and deleted through a context's table of functions, for as long as it lives:
/// one at a time.
class ObjectCount {
  public:
    explicit ObjectCount(sunder::gl::Functions&);
    ~ObjectCount();
    ObjectCount(const ObjectCount&) = delete;
    ObjectCount& operator=(const ObjectCount&) = delete;

    /// Buffers, textures, programs and all other kinds.
    int alive() const;

  private:
    sunder::gl::Functions& functions_;
    sunder::gl::Functions before_;
};
