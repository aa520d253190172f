#pragma once
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::app {

/// Another program that reads what it is fed on its standard input. Everything about processes that
/// differs from system to system is in fed_process.cpp.
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
    /// False: it no longer reads.
    bool feed(std::string_view bytes);
    /// Ends its input and waits for it to end; whether it ended well.
    bool close();
    /// What it wrote on its standard error; after close().
    std::string complaints() const;

  private:
    bool started_ = false;
    std::FILE* errors_ = nullptr;
#ifdef _WIN32
    std::FILE* input_ = nullptr;
    std::string errorName_;
#else
    int input_ = -1, process_ = -1;
    void (*pipeHandler_)(int);
#endif
};

}  // namespace sunder::app
