#pragma once
#include <cstddef>
#include <optional>
#include <string>

namespace sunder::app {

/// The processor's own name for itself, or "unknown processor".
std::string processorName();
/// Hardware threads, at least 1.
int coreCount();
/// Bytes this process has taken from the heap and not given back; nothing where the system does not
/// tell.
std::optional<std::size_t> heapBytesInUse();

}  // namespace sunder::app
