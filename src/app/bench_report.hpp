#pragma once
#include <string>

#include "app/bench_result.hpp"

namespace sunder::app {

/// The contents of --json.
std::string benchJson(const BenchReport&);
/// The contents of --svg: cost per tetrahedron and throughput against size.
std::string benchSvg(const BenchReport&);
/// "AMD EPYC 9B45, 2 cores; llvmpipe (…)"
std::string machineLine(const BenchReport&);

using Results = std::vector<BenchResult>;
/// Frames per second, drawn and not, at the scene's steps per frame and at one.
std::string framesText(const Results& whole, const Results& oneStep);
/// What so many explosions at once cost.
std::string explosionsText(const Results& calm, const Results& explosions, int count);
/// One row per size, one column per entrant.
std::string scalingText(const Results&);
std::string memoryText(const Results&);
std::string passesText(const std::vector<PassResult>&);
std::string brokenText(const Results& intact, const Results& broken);
/// The median and the slowest of the frames in which bonds break; empty where none was measured.
std::string breakingText(const Results&);
/// ms per 1/60 s.
std::string peersText(const Results&);
/// One line per result that was skipped, with the reason.
std::string skippedText(const Results&);

}  // namespace sunder::app
