#pragma once
#include <cstdint>

namespace sunder::core {

/// Bytes that this process may hope for: seven eighths of the machine's memory, as the rest of the
/// machine lives too, or less where a container or a limit of the shell allows less.
std::uint64_t usableMemory();

/// Throws InputError where a world of so many cells cannot fit into `usable` bytes, whatever solver
/// has it. Without it, a system that promises more memory than it has ends the process later,
/// without a word.
void requireMemory(std::int64_t cells, std::uint64_t usable = usableMemory());

}  // namespace sunder::core
