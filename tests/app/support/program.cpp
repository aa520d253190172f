#include "app/support/program.hpp"

#include <cstdlib>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>

#ifndef _WIN32
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>
#endif

#include "catch.hpp"

namespace fs = std::filesystem;

namespace {

std::string randomName() {
    std::random_device random;
    return "sunder-test-" + std::to_string(random()) + "-" + std::to_string(random());
}

#ifdef _WIN32
std::string quoted(const std::string& word) {
    return '"' + word + '"';
}
// cmd removes the first and the last quote of a line.
std::string shellLine(const std::string& command) {
    return '"' + command + '"';
}
int exitCodeOf(int status) {
    return status;
}
void setVariable(const std::string& name, const std::string& value) {
    _putenv_s(name.c_str(), value.c_str());
}
void unsetVariable(const std::string& name) {
    _putenv_s(name.c_str(), "");
}
#else
std::string quoted(const std::string& word) {
    std::string result = "'";
    for (const char c : word) result += c == '\'' ? "'\\''" : std::string(1, c);
    return result + "'";
}
std::string shellLine(const std::string& command) {
    return command;
}
int exitCodeOf(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}
void setVariable(const std::string& name, const std::string& value) {
    setenv(name.c_str(), value.c_str(), 1);
}
void unsetVariable(const std::string& name) {
    unsetenv(name.c_str());
}
#endif

/// Set while it lives.
class Variable {
  public:
    Variable(std::string name, const std::string& value) : name_(std::move(name)) {
        if (const char* before = std::getenv(name_.c_str())) {
            wasSet_ = true;
            before_ = before;
        }
        setVariable(name_, value);
    }
    ~Variable() {
        if (wasSet_)
            setVariable(name_, before_);
        else
            unsetVariable(name_);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    std::string name_, before_;
    bool wasSet_ = false;
};

/// The current folder while it lives; a child inherits it.
class CurrentFolder {
  public:
    explicit CurrentFolder(const fs::path& folder) : before_(fs::current_path()) {
        fs::current_path(folder);
    }
    ~CurrentFolder() {
        std::error_code ignored;
        fs::current_path(before_, ignored);
    }
    CurrentFolder(const CurrentFolder&) = delete;
    CurrentFolder& operator=(const CurrentFolder&) = delete;

  private:
    fs::path before_;
};

std::string contentsOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    INFO(path.string());
    REQUIRE(file);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

Workplace::Workplace() : root_(fs::temp_directory_path() / randomName()), work_(root_ / "work") {
    fs::create_directories(work_);
}

Workplace::~Workplace() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
}

Result Workplace::run(const std::vector<std::string>& arguments, const Environment& environment,
                      const std::string& out) const {
    return runInShell("", arguments, environment, out);
}

#ifndef _WIN32
Result Workplace::runWithFilesUpTo(int blocks, const std::vector<std::string>& arguments,
                                   const Environment& environment) const {
    // Without the trap the program would be killed, which no full disk does.
    return runInShell("trap '' XFSZ; ulimit -f " + std::to_string(blocks) + "; ", arguments,
                      environment);
}

Result Workplace::runWithMemoryUpTo(int kilobytes, const std::vector<std::string>& arguments,
                                    const Environment& environment) const {
    return runInShell("ulimit -v " + std::to_string(kilobytes) + "; ", arguments, environment);
}

bool Workplace::runAndKill(const std::vector<std::string>& arguments, int milliseconds,
                           const std::string& last) const {
    using Clock = std::chrono::steady_clock;
    std::vector<std::string> words{SUNDER_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);

    const std::set<std::string> before = contents();
    const auto appeared = [&] {
        for (const std::string& name : contents())
            if (!before.count(name) && contains(name, last) && !fs::is_directory(work_ / name))
                return true;
        return false;
    };
    const CurrentFolder here(work_);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&files, output, "/dev/null", O_WRONLY, 0);
    pid_t process = -1;
    const int error =
        posix_spawn(&process, SUNDER_PROGRAM, &files, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    REQUIRE(error == 0);
    int status = 0;
    const auto ended = [&] { return waitpid(process, &status, WNOHANG) == process; };
    const auto giveUp = Clock::now() + std::chrono::minutes(2);
    while (!appeared() && Clock::now() < giveUp)
        if (ended()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    if (ended()) return false;
    kill(process, SIGKILL);
    waitpid(process, &status, 0);
    return true;
}
#endif

Result Workplace::runInShell(const std::string& before, const std::vector<std::string>& arguments,
                             const Environment& environment,
                             const std::string& standardOutput) const {
    // Outside work_, so that contents() shows only what the program made.
    const fs::path out = root_ / "out.txt", err = root_ / "err.txt";
    std::string command = before + quoted(SUNDER_PROGRAM);
    for (const std::string& argument : arguments) command += ' ' + quoted(argument);
    command += " > " + quoted(standardOutput.empty() ? out.string() : standardOutput) + " 2> " +
               quoted(err.string());

    std::vector<std::unique_ptr<Variable>> variables;
    for (const auto& [name, value] : environment)
        variables.push_back(std::make_unique<Variable>(name, value));
    const CurrentFolder here(work_);
    Result result;
    result.command = command;
    result.exitCode = exitCodeOf(std::system(shellLine(command).c_str()));
    if (standardOutput.empty()) result.out = contentsOf(out);
    result.err = contentsOf(err);
    return result;
}

void Workplace::write(const std::string& name, const std::string& contents) const {
    std::ofstream file(path(name), std::ios::binary);
    file << contents;
    file.close();
    REQUIRE(file);
}

std::string Workplace::read(const std::string& name) const {
    return contentsOf(path(name));
}

nlohmann::json Workplace::readJson(const std::string& name) const {
    return nlohmann::json::parse(read(name));
}

std::set<std::string> Workplace::contents() const {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(work_))
        names.insert(entry.path().lexically_relative(work_).generic_string());
    return names;
}

void checkRefused(const Result& result, int exitCode, const std::vector<std::string>& parts) {
    INFO(result.command << "\nstderr: " << result.err);
    CHECK(result.exitCode == exitCode);
    CHECK(result.out.empty());
    CHECK(result.err.rfind("sunder: ", 0) == 0);
    CHECK(result.err.size() > 20);
    CHECK(result.err.size() < 1500);
    CHECK(result.err.find('\n') == result.err.size() - 1);
    for (const std::string& part : parts) {
        INFO("wanted: " << part);
        CHECK(contains(result.err, part));
    }
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}
