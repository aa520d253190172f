#pragma once
#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::image {

/// Another program that reads what it is fed on its standard input. Everything about processes that
/// differs from system to system is in fed_process_posix.cpp and fed_process_windows.cpp.
class FedProcess {
  public:
    /// Program and arguments, each taken as it is: no shell looks at them. The program is sought as
    /// a shell would.
    explicit FedProcess(const std::vector<std::string>& command);
    ~FedProcess();  ///< as close()
    FedProcess(const FedProcess&) = delete;
    FedProcess& operator=(const FedProcess&) = delete;

    /// False: there is no such program.
    bool started() const { return started_; }
    /// False: it no longer reads, or was given up.
    bool feed(std::string_view bytes);
    /// Ends its input and waits for it to end; whether it ended well.
    bool close();
    /// Whether it was killed because the user would not wait for it (signalledAgain()).
    bool givenUp() const { return givenUp_; }
    /// What it wrote on its standard error; after close().
    std::string complaints() const;

  private:
    struct System;
    /// Kills it if the user would not wait; where the system can tell.
    void giveUp();

    bool started_ = false, givenUp_ = false;
    std::FILE* errors_ = nullptr;
    std::unique_ptr<System> system_;
};

}  // namespace sunder::image
