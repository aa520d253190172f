#pragma once
#include <nlohmann/json.hpp>

/// Every result has every key, and numbers that agree with one another and with a scene of
/// `tetrahedra` and `steps` per frame ("one-step" results have one).
void checkBenchResults(const nlohmann::json& report, int tetrahedra, int steps);
