#pragma once
#include <chrono>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "support/contains.hpp"

/// What a run of the program leaves behind, besides files.
struct Result {
    int exitCode = -1;
    std::string out, err;
    std::string command;  ///< to try it by hand
};

#ifndef _WIN32
/// The program while it runs, in a process group of its own as a terminal would have it.
class RunningProgram {
  public:
    /// Its output goes to files of these names.
    RunningProgram(std::vector<std::string> arguments, std::string out, std::string err);
    ~RunningProgram();  ///< killed
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    bool running();
    /// To it alone.
    void send(int signal) const;
    /// To all in its group, as Ctrl+C in a terminal.
    void sendAll(int signal) const;
    /// Waits for its end, which must come within two minutes. 128 + n: signal n ended it.
    Result wait();

  private:
    std::string out_, err_, command_;
    int process_ = -1, code_ = -1;
};
#endif

/// Waits for `condition`, but not longer than any sound machine takes.
template <class Condition>
bool eventually(Condition&& condition) {
    for (int i = 0; i < 24000; ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

/// An empty folder, removed at the end, in which the program runs as a user would run it: a child
/// process with its own command line.
class Workplace {
  public:
    /// Variables of the program's environment.
    using Environment = std::map<std::string, std::string>;

    Workplace();
    ~Workplace();
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;

    /// `out`: where standard output goes instead of into the result.
    Result run(const std::vector<std::string>& arguments, const Environment& = {},
               const std::string& out = {}) const;
#ifndef _WIN32
    /// As if the disk were full: no file may become larger than this, in units of 512 bytes.
    Result runWithFilesUpTo(int blocks, const std::vector<std::string>& arguments,
                            const Environment& = {}) const;
    /// With so many kilobytes of addresses at most, which is more than it will have in memory.
    Result runWithMemoryUpTo(int kilobytes, const std::vector<std::string>& arguments,
                             const Environment& = {}) const;
    /// Starts the program and does not wait for it.
    RunningProgram start(const std::vector<std::string>& arguments, const Environment& = {}) const;
    /// Starts the program and kills it (SIGKILL) so many milliseconds after it made its first file
    /// or, where `last` is not empty, one whose name has `last` in it. False: it had ended before.
    bool runAndKill(const std::vector<std::string>& arguments, int milliseconds,
                    const std::string& last = {}) const;
#endif

    void write(const std::string& name, const std::string& contents) const;
    std::string read(const std::string& name) const;
    nlohmann::json readJson(const std::string& name) const;
    std::filesystem::path path(const std::string& name) const;
    /// Every file and folder in it, by its path within.
    std::set<std::string> contents() const;

  private:
    Result runInShell(const std::string& before, const std::vector<std::string>& arguments,
                      const Environment&, const std::string& standardOutput = {}) const;

    std::filesystem::path root_, work_;
};

/// No OpenGL context can be had: what works with this needs none.
inline const Workplace::Environment kNoGl{{"SUNDER_EGL_DEVICE", "99"}};

/// The program gave up with this exit code, printed nothing but one line on stderr beginning with
/// `sunder: `, and that line has all these parts.
void checkRefused(const Result&, int exitCode, const std::vector<std::string>& parts);
