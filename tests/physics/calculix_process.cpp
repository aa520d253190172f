#include "physics/calculix_process.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#ifdef _WIN32
#define popen _popen
#define pclose _pclose
#endif

namespace fs = std::filesystem;

namespace {

/// What ccx says, run in `folder`. The words are the same for sh and cmd. Its exit code says
/// nothing: `ccx -v` gives 201.
std::string ccx(const fs::path& folder, const std::string& arguments) {
    const std::string command = "cd \"" + folder.string() + "\" && ccx " + arguments + " 2>&1";
    std::FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) throw std::runtime_error("no process can be started for: " + command);
    std::string said;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) said += static_cast<char>(c);
    pclose(pipe);
    return said;
}

fs::path folderOf(const std::string& name) {
    return fs::path(SUNDER_PHYSICS_WORK) / name;
}

}  // namespace

std::string calculixHere() {
    const std::string said = ccx(".", "-v"), words = "This is Version ";
    const std::size_t at = said.find(words);
    if (at == std::string::npos) return {};
    std::string version;
    std::istringstream(said.substr(at + words.size())) >> version;
    return "CalculiX " + version;
}

void leaveInput(const std::string& name, const std::string& input) {
    fs::create_directories(folderOf(name));
    std::ofstream(folderOf(name) / (name + ".inp"), std::ios::binary) << input;
}

std::string runCalculix(const std::string& name) {
    const fs::path folder = folderOf(name), printed = folder / (name + ".dat");
    fs::remove(printed);
    const std::string said = ccx(folder, "-i \"" + name + "\"");
    std::ostringstream output;
    if (std::ifstream file(printed); file && file.peek() != EOF) output << file.rdbuf();
    if (output.str().empty())
        throw std::runtime_error("CalculiX has no answer to " + (folder / name).string() +
                                 ".inp; it said: " + said);
    return output.str();
}
