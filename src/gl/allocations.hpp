#pragma once
#include <cstddef>
#include <unordered_map>

#include "gl/functions.hpp"

namespace sunder::gl {

/// Sizes of the objects of one kind that are alive in one context, by name.
class Allocations {
  public:
    void add(GLuint id, std::size_t bytes) {
        remove(id);
        sizes_[id] = bytes;
        total_ += bytes;
    }
    void remove(GLuint id) {
        const auto found = sizes_.find(id);
        if (found == sizes_.end()) return;
        total_ -= found->second;
        sizes_.erase(found);
    }
    std::size_t total() const { return total_; }

  private:
    std::unordered_map<GLuint, std::size_t> sizes_;
    std::size_t total_ = 0;
};

}  // namespace sunder::gl
