#pragma once
#include <chrono>
#include <string>

namespace sunder::app {

/// One line on a terminal that is redrawn at most ten times a second; nothing where stderr is not a
/// terminal.
class Progress {
  public:
    Progress(std::string what, int total);
    ~Progress();  ///< clears the line
    void update(int done);

  private:
    std::string what_;
    int total_;
    bool terminal_;
    std::chrono::steady_clock::time_point start_, last_{};
};

}  // namespace sunder::app
