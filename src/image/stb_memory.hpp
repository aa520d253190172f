#pragma once
#include <cstddef>

namespace sunder::image {

/// The most that stb may ask for at once while this lives, bytes, in this thread. A few kilobytes
/// of a PNG can be made to unpack into gigabytes, whatever size it says the picture has.
class StbMemoryLimit {
  public:
    explicit StbMemoryLimit(std::size_t bytes);
    ~StbMemoryLimit();
    StbMemoryLimit(const StbMemoryLimit&) = delete;
    StbMemoryLimit& operator=(const StbMemoryLimit&) = delete;
};

}  // namespace sunder::image
