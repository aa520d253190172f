#include "physics/calculix_process.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "physics/calculix.hpp"

namespace fs = std::filesystem;

namespace {

fs::path workFolder() {
    const fs::path folder = SUNDER_PHYSICS_WORK;
    fs::create_directories(folder);
    return folder;
}

std::string contents(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// Runs ccx in the work folder; what it says goes to `log` there. The words are the same for sh and
/// cmd. Its exit code says nothing: `ccx -v` gives 201.
void ccx(const std::string& arguments, const std::string& log) {
    const std::string command =
        "cd \"" + workFolder().string() + "\" && ccx " + arguments + " > \"" + log + "\" 2>&1";
    [[maybe_unused]] const int status = std::system(command.c_str());
}

}  // namespace

std::string calculixVersion() {
    ccx("-v", "version.log");
    const std::string said = contents(workFolder() / "version.log"), words = "This is Version ";
    const std::size_t at = said.find(words);
    if (at == std::string::npos)
        throw std::runtime_error(
            "CalculiX's program ccx cannot be run: install the package calculix-ccx");
    std::string version;
    std::istringstream(said.substr(at + words.size())) >> version;
    return "CalculiX " + version;
}

std::string runCalculix(const std::string& name, const std::string& input) {
    calculixVersion();
    const fs::path base = workFolder() / name;
    fs::remove(base.string() + ".dat");
    std::ofstream(base.string() + ".inp") << input;
    ccx("-i \"" + name + "\"", name + ".log");
    const std::string output = contents(base.string() + ".dat");
    if (output.empty())
        throw std::runtime_error("CalculiX printed nothing for " + base.string() +
                                 ".inp: its .log says why");
    return output;
}
