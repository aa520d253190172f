#pragma once
#include <string>
#include <vector>

#include "app/bench_contest.hpp"
#include "app/bench_report.hpp"

namespace sunder::app {

/// Draws `state` over and over.
DrawingResult measureDrawing(const scene::Scene&, const core::World&, const core::State&,
                             const std::string& name, const BenchLimits&);

/// ms, median: making the display mesh of a wooden wall of 2,000 cells.
double measureDisplayMeshBuild(const BenchLimits&);

std::string drawingText(const std::vector<DrawingResult>&, double msBuild);

}  // namespace sunder::app
