#pragma once
#include <string>
#include <vector>

/// For tools/update-states: stores what the solvers of this program compute in the scenes of
/// tests/states, or in the one that is named. Throws on a CI machine, and where there is no such
/// scene.
void updateStates(const std::vector<std::string>& scene);
