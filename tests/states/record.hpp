#pragma once
#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include "core/solver.hpp"

/// Hashes of what a run wrote: of its state at the start, and of each pass of every step. Where two
/// records part tells which step did something else, and which pass of it.
struct RecordEntry {
    struct Hash {
        std::string what;   ///< "state", or a pass
        std::string value;  ///< hex; a shorter one stands for all that begin with it
    };
    std::int64_t step;         ///< after so many, or of that one, the first being 1
    std::vector<Hash> hashes;  ///< one of the state; or of passes, in the order they come
    bool ofState() const { return hashes.front().what == "state"; }
};
using Record = std::vector<RecordEntry>;

/// One entry per line, after a line that names the passes; `-`: did not run; `.`: wrote the same as
/// when it last ran. Four digits of a pass are enough: one change in 65,536 is seen a step late.
///     0 state 9b978503297d9320
///     passes elements nodes bonds
///     1 0a6e b279 783c
///     2 1bb4 05ed .
/// Lines that begin with # are left out. Throws InputError naming file and line.
Record parseRecord(std::istream&, const std::string& file);
Record readRecord(const std::filesystem::path&);
std::string toText(const Record&);

/// What a file has hashes of: the state at the start, and the passes of so many steps.
Record everyStep(int steps);

/// Runs from where the solver is through the steps of `plan` and hashes what it has hashes of.
Record record(sunder::core::Solver&, const Record& plan);

/// A sentence: which step is the first that differs, and in which pass. Empty: none.
std::string firstDifference(const Record& stored, const Record& now, int stepsPerFrame);
