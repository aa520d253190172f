#pragma once
#include <CLI/CLI.hpp>
#include <cstdint>

namespace sunder::app {

// Checks of options in our own words: CLI11's differ from version to version, its Range lets nan
// through, and it takes -1 for 2^64 - 1.

/// A whole number from `min` to `max`.
CLI::Validator wholeNumber(std::uint64_t min, std::uint64_t max);
/// A number from `min` to `max`.
CLI::Validator number(int min, int max);

}  // namespace sunder::app
