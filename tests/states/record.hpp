#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/solver.hpp"

/// Hashes of what a run wrote: of its state after some steps, and of each pass of some steps. Where
/// two records part tells which step did something else, and which pass of it.
struct RecordEntry {
    struct Hash {
        std::string what;   ///< "state", or a pass
        std::string value;  ///< hex
    };
    std::int64_t step;         ///< after so many, or of that one, the first being 1
    std::vector<Hash> hashes;  ///< one of the state; or of passes, in the order they come
    bool ofState() const { return hashes.front().what == "state"; }
};
using Record = std::vector<RecordEntry>;

/// One entry per line: "301 elements 1a2b3c4d nodes 5e6f7a8b". Lines that begin with # are left
/// out. Throws InputError naming file and line.
Record readRecord(const std::filesystem::path&);
std::string toText(const Record&);

/// The steps and frames that are worth a place in a file: the state after each frame, and the
/// passes of the first steps, of those that an event begins in, and of those in which a pass first
/// does anything. Advances the solver by that many frames, watching every step.
Record planRecord(const sunder::World&, sunder::Solver&, int frames, int stepsPerFrame);

/// Runs from where the solver is through the steps of `plan` and hashes what it has hashes of.
Record record(sunder::Solver&, const Record& plan);

/// A sentence: which step is the first that differs, and in which pass. Empty: none.
std::string firstDifference(const Record& stored, const Record& now, int stepsPerFrame);
