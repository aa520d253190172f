#include "core/memory.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "core/types.hpp"

#if defined(_WIN32)
#ifndef NOMINMAX  // GCC's library defines it
#define NOMINMAX
#endif
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
#else
#include <sys/resource.h>
#include <unistd.h>
#ifdef __APPLE__
#include <sys/sysctl.h>
#endif
#endif

namespace sunder::core {
namespace {

/// `sunder run` with the solver cpu, the most frugal one, takes 1,140 of 400,000 cells and 1,240 of
/// 1,600,000: the world has 90 of them, a state 432.
constexpr std::uint64_t kBytesPerCell = 1150;
constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

std::uint64_t physicalMemory() {
#if defined(_WIN32)
    MEMORYSTATUSEX status = {};
    status.dwLength = sizeof status;
    return GlobalMemoryStatusEx(&status) ? status.ullTotalPhys : kNoLimit;
#elif defined(__APPLE__)
    std::uint64_t bytes = 0;
    std::size_t size = sizeof bytes;
    return sysctlbyname("hw.memsize", &bytes, &size, nullptr, 0) == 0 ? bytes : kNoLimit;
#else
    const auto pages = sysconf(_SC_PHYS_PAGES), pageBytes = sysconf(_SC_PAGESIZE);
    return pages > 0 && pageBytes > 0
               ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(pageBytes)
               : kNoLimit;
#endif
}

/// Set for this process from outside.
std::uint64_t imposedLimit() {
    std::uint64_t limit = kNoLimit;
#if !defined(_WIN32)
    rlimit addresses = {};
    if (getrlimit(RLIMIT_AS, &addresses) == 0 && addresses.rlim_cur != RLIM_INFINITY)
        limit = addresses.rlim_cur;
#endif
#if defined(__linux__)
    // As a container sees its own control group, of version 2 and 1; "max" is no number.
    for (const char* name :
         {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        std::uint64_t bytes = 0;
        if (std::ifstream(name) >> bytes) limit = std::min(limit, bytes);
    }
#endif
    return limit;
}

std::string gigabytes(std::uint64_t bytes) {
    const std::uint64_t tenths = (bytes + 50'000'000) / 100'000'000;
    return std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10) + " GB";
}

}  // namespace

std::uint64_t usableMemory() {
    return std::min(physicalMemory() / 8 * 7, imposedLimit());
}

void requireMemory(std::int64_t cells, std::uint64_t usable) {
    const std::uint64_t needed = kBytesPerCell * static_cast<std::uint64_t>(cells);
    if (needed <= usable) return;
    throw MemoryError("the world is too large for this machine's memory: " + std::to_string(cells) +
                      " cells take at least " + gigabytes(needed) + ", and there are " +
                      gigabytes(usable) + "; use at most " +
                      std::to_string(usable / kBytesPerCell) + " cells");
}

}  // namespace sunder::core
