#pragma once
#include <string>

/// Runs CalculiX's program ccx on an input file and returns what it printed (its .dat file). Files
/// are left in physics-calculix/NAME of the build folder.
std::string runCalculix(const std::string& name, const std::string& input);
