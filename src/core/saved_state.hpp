#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/solver.hpp"

namespace sunder::core {

// All that a solver knows, as bytes, for rollback and checkpoints: unlike State, which leaves out
// what sleeps since when, which contacts the last search found, and more. Little-endian:
//
//   8   kStateMagic
//   4   kStateFormat
//   12  name of the solver, then zeros
//   8   World::fingerprint()
//   8   number of bytes, all of them
//   …   what the solver's parts keep (core/archive.hpp), and which bodies are to come or go
//   8   checksum: 64-bit FNV-1a of everything before it

inline constexpr char kStateMagic[] = "SundSave";
/// Another one with every change of what any part of a solver archives.
inline constexpr std::uint32_t kStateFormat = 4;

/// What a solver has yet to be told by Solver::setPresent(), and then by releaseAnchors().
struct PresenceChange {
    int body = 0;
    bool present = false;
    bool released = false;  ///< whether its anchors let go as it comes
};

/// Where `solver` is, and what it has yet to be told. It goes on as if nothing had happened, to the
/// bit, and so does every solver of the same name and of an equal world that restores the bytes,
/// advanced by the same numbers of steps. `auto` restores as setState() does: what sleeps wakes,
/// what may touch is searched for anew. Waits for a GPU, as finish() does: incidents that were
/// found go to the ring, and those after it are found again by whoever restores. What a look
/// compares with (recent impulses, known breaks) is among the bytes where incidents are looked for.
/// On the thread that advances the solver, as restoreState().
std::vector<std::byte> saveState(const World& world, Solver& solver,
                                 std::vector<PresenceChange> changes = {});

/// Goes on from there; returns the step, and in `changes` what the solver has yet to be told then.
/// `solver` is one of `world`. Incidents found before are
/// left to whoever takes them. Throws InputError, and then nothing has changed, for bytes that are
/// cut, changed, of another format, another solver or another world, or that no solver writes; also
/// where a number is no longer finite.
std::int64_t restoreState(const World& world, Solver& solver, std::span<const std::byte> bytes,
                          std::vector<PresenceChange>& changes);
/// Of states saved without any; what else they have is left out.
std::int64_t restoreState(const World& world, Solver& solver, std::span<const std::byte> bytes);

/// Of all bytes but the last eight.
std::uint64_t stateChecksum(std::span<const std::byte> bytes);

}  // namespace sunder::core
