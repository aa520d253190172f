#include "app/support/program.hpp"

#include <cstdlib>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>

#ifndef _WIN32
#include <sys/wait.h>
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

Result Workplace::run(const std::vector<std::string>& arguments,
                      const Environment& environment) const {
    // Outside work_, so that contents() shows only what the program made.
    const fs::path out = root_ / "out.txt", err = root_ / "err.txt";
    std::string command = quoted(SUNDER_PROGRAM);
    for (const std::string& argument : arguments) command += ' ' + quoted(argument);
    command += " > " + quoted(out.string()) + " 2> " + quoted(err.string());

    std::vector<std::unique_ptr<Variable>> variables;
    for (const auto& [name, value] : environment)
        variables.push_back(std::make_unique<Variable>(name, value));
    const CurrentFolder here(work_);
    Result result;
    result.command = command;
    result.exitCode = exitCodeOf(std::system(shellLine(command).c_str()));
    result.out = contentsOf(out);
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
