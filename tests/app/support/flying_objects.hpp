#pragma once
#include <nlohmann/json.hpp>
#include <string>

/// Objects that touch nothing: one in flight, an obstacle, one that is thrown after the end.
namespace flying {

/// Five frames.
std::string scene();
/// What a report must say of them: where the laws of free flight have them, in `kTolerance`.
void check(const nlohmann::json& report);
/// Positions of some metres in single precision, as GPUs keep them, after 250 sums.
inline constexpr double kTolerance = 2e-4;

}  // namespace flying
