#include "app/progress.hpp"

#include <cstdio>
#include <iostream>

namespace sunder::app {
namespace {

constexpr int kBarWidth = 32;

}  // namespace

Progress::Progress(std::string what, int total)
    : what_(std::move(what)),
      total_(total),
      terminal_(files::standardError()),
      start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
    if (terminal_ != files::Terminal::None) show("");
}

void Progress::update(int done) {
    const auto now = std::chrono::steady_clock::now();
    if (terminal_ == files::Terminal::None ||
        (done < total_ && now - last_ < std::chrono::milliseconds(100)))
        return;
    last_ = now;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const int filled = kBarWidth * done / total_;
    std::string bar(filled, '#');
    bar.append(kBarWidth - filled, '.');
    char text[96];
    std::snprintf(text, sizeof text, "] %d/%d, %.0f s left", done, total_,
                  done ? elapsed * (total_ - done) / done : 0.0);
    show(what_ + " [" + bar + (done ? text : "]"));
}

void Progress::show(const std::string& line) {
    std::cerr << '\r' << line;
    if (terminal_ == files::Terminal::Escapes) {
        std::cerr << "\x1b[K";
    } else {
        // Spaces over what is left of the line before.
        if (line.size() < shown_) std::cerr << std::string(shown_ - line.size(), ' ');
        if (line.empty()) std::cerr << '\r';
        shown_ = line.size();
    }
    std::cerr << std::flush;
}

}  // namespace sunder::app
