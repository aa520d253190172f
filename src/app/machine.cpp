#include "app/machine.hpp"

#include <algorithm>
#include <fstream>
#include <thread>

#include "files/system.hpp"

#ifdef __APPLE__
#include <sys/sysctl.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace sunder::app {
namespace {

std::string queryProcessor() {
#if defined(_WIN32)
    return files::environmentVariable("PROCESSOR_IDENTIFIER");
#elif defined(__APPLE__)
    char name[256] = {};
    std::size_t size = sizeof name - 1;
    return sysctlbyname("machdep.cpu.brand_string", name, &size, nullptr, 0) == 0 ? name : "";
#else
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("model name")) continue;
        const std::size_t value = line.find_first_not_of(" \t", line.find(':') + 1);
        return value < line.size() ? line.substr(value) : "";
    }
    return {};
#endif
}

}  // namespace

std::string processorName() {
    const std::string name = queryProcessor();
    return name.empty() ? "unknown processor" : name;
}

int coreCount() {
    return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

std::optional<std::size_t> heapBytesInUse() {
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
#else
    return std::nullopt;
#endif
}

}  // namespace sunder::app
