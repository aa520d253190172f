#pragma once
#include <chrono>
#include <cstddef>
#include <string>

#include "files/system.hpp"

namespace sunder::app {

/// One line on a terminal that is redrawn at most ten times a second; nothing where stderr is not a
/// terminal.
class Progress {
  public:
    Progress(std::string what, int total);
    ~Progress();  ///< clears the line
    void update(int done);

  private:
    void show(const std::string& line);

    std::string what_;
    int total_;
    files::Terminal terminal_;
    std::size_t shown_ = 0;  ///< bytes of the line on a plain terminal
    std::chrono::steady_clock::time_point start_, last_{};
};

}  // namespace sunder::app
