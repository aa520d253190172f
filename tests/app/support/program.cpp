#include "app/support/program.hpp"

#include <cstdlib>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>

#ifdef _WIN32
#include "files/utf16_windows.hpp"
#else
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>
#endif

#include "catch.hpp"
#include "files/utf8_path.hpp"

using sunder::files::pathFromUtf8, sunder::files::utf8FromPath;

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
int runShell(const std::string& command) {
    // cmd's code for a program that it could not start. Wine's cmd now and then cannot start one
    // that is there when the machine is busy; nothing has run then.
    constexpr int kNotStarted = 9009;
    int code = kNotStarted;
    for (int attempt = 0; attempt < 5 && code == kNotStarted; ++attempt)
        // cmd removes the first and the last quote of a line.
        code = _wsystem(sunder::files::utf16FromUtf8('"' + command + '"').c_str());
    return code;
}
int exitCodeOf(int status) {
    return status;
}
void setVariable(const std::string& name, const std::string& value) {
    _wputenv_s(sunder::files::utf16FromUtf8(name).c_str(),
               sunder::files::utf16FromUtf8(value).c_str());
}
void unsetVariable(const std::string& name) {
    setVariable(name, "");
}
#else
std::string quoted(const std::string& word) {
    std::string result = "'";
    for (const char c : word) result += c == '\'' ? "'\\''" : std::string(1, c);
    return result + "'";
}
int runShell(const std::string& command) {
    return std::system(command.c_str());
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

/// All of them, set while it lives.
class SetVariables {
  public:
    explicit SetVariables(const Workplace::Environment& environment) {
        for (const auto& [name, value] : environment)
            variables_.push_back(std::make_unique<Variable>(name, value));
    }

  private:
    std::vector<std::unique_ptr<Variable>> variables_;
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
    INFO(sunder::files::utf8FromPath(path));
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

RunningProgram Workplace::start(const std::vector<std::string>& arguments,
                                const Environment& environment) const {
    const SetVariables variables(environment);
    const CurrentFolder here(work_);
    // Outside work_, so that contents() shows only what the program made.
    const std::string own = (root_ / randomName()).string();
    return {arguments, own + "-out.txt", own + "-err.txt"};
}

bool Workplace::runAndKill(const std::vector<std::string>& arguments, int milliseconds,
                           const std::string& last) const {
    const std::set<std::string> before = contents();
    const auto appeared = [&] {
        for (const std::string& name : contents())
            if (!before.count(name) && contains(name, last) && !fs::is_directory(work_ / name))
                return true;
        return false;
    };
    RunningProgram program = start(arguments);
    using Clock = std::chrono::steady_clock;
    const auto giveUp = Clock::now() + std::chrono::minutes(2);
    while (!appeared() && Clock::now() < giveUp)
        if (!program.running()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    if (!program.running()) return false;
    program.send(SIGKILL);
    program.wait();
    return true;
}

RunningProgram::RunningProgram(std::vector<std::string> arguments, std::string out, std::string err)
    : out_(std::move(out)), err_(std::move(err)) {
    arguments.insert(arguments.begin(), SUNDER_PROGRAM);
    std::vector<char*> pointers;
    for (std::string& word : arguments) {
        command_ += ::quoted(word) + ' ';
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    constexpr int kNew = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out_.c_str(), kNew, 0600);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err_.c_str(), kNew, 0600);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setpgroup(&attributes, 0);
    // Not ignored, whatever started these tests ignores.
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals, signal);
    posix_spawnattr_setsigdefault(&attributes, &signals);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    pid_t process = -1;
    const int error =
        posix_spawn(&process, SUNDER_PROGRAM, &files, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    REQUIRE(error == 0);
    process_ = process;
}

RunningProgram::~RunningProgram() {
    if (!running()) return;
    send(SIGKILL);
    waitpid(process_, nullptr, 0);
}

bool RunningProgram::running() {
    int status = 0;
    if (code_ >= 0) return false;
    if (waitpid(process_, &status, WNOHANG) != process_) return true;
    code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return false;
}

void RunningProgram::send(int signal) const {
    kill(process_, signal);
}

void RunningProgram::sendAll(int signal) const {
    kill(-process_, signal);
}

Result RunningProgram::wait() {
    INFO(command_);
    REQUIRE(eventually([&] { return !running(); }));
    return {code_, contentsOf(out_), contentsOf(err_), command_};
}
#endif

Result Workplace::runInShell(const std::string& before, const std::vector<std::string>& arguments,
                             const Environment& environment,
                             const std::string& standardOutput) const {
    // Outside work_, so that contents() shows only what the program made.
    const fs::path out = root_ / "out.txt", err = root_ / "err.txt";
    std::string command = before + quoted(SUNDER_PROGRAM);
    for (const std::string& argument : arguments) command += ' ' + quoted(argument);
    command += " > " +
               quoted(standardOutput.empty() ? sunder::files::utf8FromPath(out) : standardOutput) +
               " 2> " + quoted(sunder::files::utf8FromPath(err));

    const SetVariables variables(environment);
    const CurrentFolder here(work_);
    Result result;
    result.command = command;
    result.exitCode = exitCodeOf(runShell(command));
    if (standardOutput.empty()) result.out = contentsOf(out);
    result.err = contentsOf(err);
    // Windows ends lines with two characters.
    for (std::string* text : {&result.out, &result.err}) std::erase(*text, '\r');
    return result;
}

std::filesystem::path Workplace::path(const std::string& name) const {
    return work_ / sunder::files::pathFromUtf8(name);
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
    // A program that runs may remove a folder while it is read: then what it holds is asked again.
    for (int attempt = 0; attempt < 100; ++attempt) {
        std::set<std::string> names;
        std::error_code error;
        for (fs::recursive_directory_iterator at(work_, error), end; !error && at != end;
             at.increment(error))
            names.insert(sunder::files::utf8FromPath(at->path().lexically_relative(work_)));
        if (!error) return names;
    }
    FAIL("the folder of the test cannot be read");
    return {};
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
