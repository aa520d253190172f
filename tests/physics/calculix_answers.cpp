#include "physics/calculix_answers.hpp"

#include <cstdint>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "files/write_file.hpp"

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLargestStoredInput =
    100'000;  // bytes: larger ones would make the repository large
constexpr const char* kRunAs = ", run as `ccx -i ";

/// Tells inputs apart that no one made alike on purpose: FNV-1a.
std::string fingerprint(const std::string& text) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    std::ostringstream hex;
    hex << std::hex << std::setfill('0') << std::setw(16) << hash;
    return hex.str();
}

/// First line of NAME.dat behind the program.
std::string howAnswered(const std::string& name, const std::string& input) {
    return kRunAs + name + "` on " + std::to_string(input.size()) + " bytes, FNV-1a " +
           fingerprint(input);
}

/// Empty where there is none. Without the carriage returns that a checkout may have added.
std::string textOf(const fs::path& path) {
    std::ostringstream text;
    if (std::ifstream file(path, std::ios::binary); file && file.peek() != EOF)
        text << file.rdbuf();
    std::string all = text.str();
    std::erase(all, '\r');
    return all;
}

/// A sentence on the first line in which two texts part.
std::string firstDifference(const std::string& stored, const std::string& now) {
    std::istringstream before(stored), after(now);
    std::string one, other;
    for (int line = 1;; ++line) {
        const bool more = static_cast<bool>(std::getline(before, one));
        const bool moreNow = static_cast<bool>(std::getline(after, other));
        if (!more && !moreNow) return {};
        if (more != moreNow || one != other)
            return " Line " + std::to_string(line) + " was '" + (more ? one : "") + "' and is '" +
                   (moreNow ? other : "") + "'.";
    }
}

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
    throw std::runtime_error(why +
                             " If the input of this test is right, renew the answer where CalculiX "
                             "is installed: tools/update-calculix " +
                             name);
}

/// NAME.dat in three parts: the program; how it was asked, and what; what it printed.
struct StoredAnswer {
    std::string program, how, printed;
};

StoredAnswer readAnswer(const fs::path& folder, const std::string& name) {
    const std::string stored = textOf(folder / (name + ".dat"));
    const std::size_t end = stored.find('\n'), at = stored.find(kRunAs);
    if (end == std::string::npos || at > end)
        refuse(name,
               "No answer of CalculiX is stored in " + (folder / (name + ".dat")).string() + ".");
    return {stored.substr(0, at), stored.substr(at, end - at), stored.substr(end + 1)};
}

}  // namespace

std::string storedProgram(const fs::path& folder, const std::string& name) {
    return readAnswer(folder, name).program;
}

CalculixAnswer storedAnswer(const fs::path& folder, const std::string& name,
                            const std::string& input) {
    const StoredAnswer stored = readAnswer(folder, name);
    const std::string inputThen = textOf(folder / (name + ".inp"));
    const bool sameInput =
        inputThen.empty() ? input.size() > kLargestStoredInput : inputThen == input;
    if (stored.how != howAnswered(name, input) || !sameInput)
        refuse(name, "CalculiX's stored answer " + (folder / (name + ".dat")).string() +
                         " is to another input than this test has." +
                         (inputThen.empty() ? "" : firstDifference(inputThen, input)));
    return {stored.program, stored.printed};
}

void storeAnswer(const fs::path& folder, const std::string& name, const std::string& input,
                 const CalculixAnswer& answer) {
    fs::create_directories(folder);
    sunder::files::writeFile(folder / (name + ".dat"),
                             answer.program + howAnswered(name, input) + '\n' + answer.printed);
    if (input.size() <= kLargestStoredInput)
        sunder::files::writeFile(folder / (name + ".inp"), input);
    else
        fs::remove(folder / (name + ".inp"));
}
