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

    Result run(const std::vector<std::string>& arguments, const Environment& = {}) const;

    void write(const std::string& name, const std::string& contents) const;
    std::string read(const std::string& name) const;
    nlohmann::json readJson(const std::string& name) const;
    std::filesystem::path path(const std::string& name) const { return work_ / name; }
    /// Every file and folder in it, by its path within.
    std::set<std::string> contents() const;

  private:
    std::filesystem::path root_, work_;
};

/// No OpenGL context can be had: what works with this needs none.
inline const Workplace::Environment kNoGl{{"SUNDER_EGL_DEVICE", "99"}};

/// The program gave up with this exit code, printed nothing but one line on stderr beginning with
/// `sunder: `, and that line has all these parts.
void checkRefused(const Result&, int exitCode, const std::vector<std::string>& parts);

bool contains(const std::string& text, const std::string& part);
