#pragma once
#include <string>
#include <vector>

#include "app/bench_contest.hpp"
#include "app/bench_report.hpp"

namespace sunder::app {

/// Frames of a scene through the public library (src/sunder/sunder.hpp) and by the solver alone,
/// in turn: with `cpu` and all cores, and with `gather` where there is a context, which the library
/// uses as a guest.
std::vector<LibraryResult> measureLibrary(const scene::Scene&, const BenchLimits&,
                                          const window::Context* context);

std::string libraryText(const std::vector<LibraryResult>&);

}  // namespace sunder::app
