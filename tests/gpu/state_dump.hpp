#pragma once
#include <map>
#include <string>
#include <vector>

/// All that the current GL context says of its state, by name. Written from the state tables of the
/// specification (GL 4.1, chapter 6; what GL 4.2 to 4.6 and the compatibility profile add), and on
/// purpose from nothing that gl::Visit knows. What a driver does not know is left out.
using StateDump = std::map<std::string, std::string>;
StateDump dumpState();

/// "NAME: before → after" for all that differs.
std::vector<std::string> differences(const StateDump& before, const StateDump& after);
