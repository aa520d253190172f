#include "sim/layout.hpp"

#include <utility>

namespace sunder::sim {

Layout::Layout(core::WorldDescription description) : world_(std::move(description)) {}

}  // namespace sunder::sim
