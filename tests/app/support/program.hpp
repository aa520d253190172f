#pragma once
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

/// What a run of the program leaves behind, besides files.
struct Result {
    int exitCode = -1;
    std::string out, err;
    std::string command;  ///< to try it by hand
};

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
    /// Starts the program and kills it (SIGKILL) so many milliseconds after it made its first file
    /// or, where `last` is not empty, one whose name has `last` in it. False: it had ended before.
    bool runAndKill(const std::vector<std::string>& arguments, int milliseconds,
                    const std::string& last = {}) const;
#endif

    void write(const std::string& name, const std::string& contents) const;
    std::string read(const std::string& name) const;
    nlohmann::json readJson(const std::string& name) const;
    std::filesystem::path path(const std::string& name) const {
        return work_ / name;
    }
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

bool contains(const std::string& text, const std::string& part);
