#pragma once
#include <string>

/// For example "CalculiX 2.20"; empty where its program `ccx` cannot be run.
std::string calculixHere();

/// Leaves an input file in physics-calculix/NAME of the build folder.
void leaveInput(const std::string& name, const std::string& input);

/// Runs `ccx` on the input that was left there and returns what it printed (its .dat file).
std::string runCalculix(const std::string& name);
