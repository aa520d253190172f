#include "app/progress.hpp"

#include <cstdio>
#include <iostream>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace sunder::app {
namespace {

bool standardErrorIsTerminal() {
#ifdef _WIN32
    return _isatty(_fileno(stderr)) != 0;
#else
    return isatty(STDERR_FILENO) != 0;
#endif
}

constexpr int kBarWidth = 32;

}  // namespace

Progress::Progress(std::string what, int total)
    : what_(std::move(what)),
      total_(total),
      terminal_(standardErrorIsTerminal()),
      start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
    if (terminal_) std::cerr << "\r\x1b[K" << std::flush;
}

void Progress::update(int done) {
    const auto now = std::chrono::steady_clock::now();
    if (!terminal_ || (done < total_ && now - last_ < std::chrono::milliseconds(100))) return;
    last_ = now;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const int filled = kBarWidth * done / total_;
    std::string bar(filled, '#');
    bar.append(kBarWidth - filled, '.');
    char text[96];
    std::snprintf(text, sizeof text, "] %d/%d, %.0f s left", done, total_,
                  done ? elapsed * (total_ - done) / done : 0.0);
    std::cerr << '\r' << what_ << " [" << bar << (done ? text : "]") << "\x1b[K" << std::flush;
}

}  // namespace sunder::app
