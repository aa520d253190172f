// Every file of the folders named on the command line, given to a fuzzer's one function: the corpus
// as a test, in any build. An input that takes too long ends it as a crash would: some are in the
// corpus because they once did.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "files/utf8_path.hpp"
#include "fuzz/fuzzer.hpp"

namespace {

/// s of processor time for one input, so that a busy machine changes nothing. The slowest, calls of
/// the library, takes 0.08 s, 30 times as much under sanitizers and more in emulation. What needs
/// more grows with some number in its file, and has no bound.
constexpr double kLimit = 100;

/// When the input began.
std::atomic<std::clock_t> start;

/// Also what has no end is found, so the clock is watched meanwhile.
void watch() {
    while (true) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        const double took = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        if (took < kLimit) continue;
        std::cout << "this input takes more than " << kLimit << " s" << std::endl;
        std::_Exit(1);
    }
}

}  // namespace

int main(int argc, char** argv) {
    start = std::clock();
    std::thread(watch).detach();
    int files = 0;
    double slowest = 0;
    for (int i = 1; i < argc; ++i)
        for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
            // Before, so that the last line names the file of a crash.
            std::cout << sunder::files::utf8FromPath(entry.path()) << std::endl;
            std::ifstream file(entry.path(), std::ios::binary);
            // A vector of exactly this size: a byte read beyond it is found by a sanitizer.
            const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
            start = std::clock();
            LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                   bytes.size());
            slowest = std::max(slowest, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
            ++files;
        }
    std::cout << files << " files, the slowest took " << slowest << " s\n";
    return files > 0 ? 0 : 1;
}
