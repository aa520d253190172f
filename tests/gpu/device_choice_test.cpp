#include <cctype>
#include <cstdlib>
#include <string>

#include "catch.hpp"
#include "command.hpp"
#include "support/contains.hpp"
#include "support/test_folder.hpp"
#include "window/context.hpp"

#ifdef __linux__
#include <sys/wait.h>

#include <filesystem>
#include <fstream>
#endif

using namespace sunder;
using namespace sunder::core;
using namespace sunder::gl;
using namespace sunder::window;

namespace {

void setVariable(const char* name, const std::string& value) {
#ifdef _WIN32
    _putenv_s(name, value.c_str());
#else
    setenv(name, value.c_str(), 1);
#endif
}

/// SUNDER_EGL_DEVICE while it lives.
class DeviceChoice {
  public:
    explicit DeviceChoice(const std::string& value) { setVariable(kName, value); }
    ~DeviceChoice() { setVariable(kName, before_); }
    DeviceChoice(const DeviceChoice&) = delete;
    DeviceChoice& operator=(const DeviceChoice&) = delete;

  private:
    static constexpr const char* kName = "SUNDER_EGL_DEVICE";
    std::string before_ = std::getenv(kName) ? std::getenv(kName) : "";
};

/// The DeviceError that comes of `choice`; empty when a context does.
std::string refusal(const std::string& choice) {
    const DeviceChoice chosen(choice);
    try {
        createHeadlessContext();
    } catch (const DeviceError& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("A device that is not there is refused, with the list of those that are") {
    for (const std::string choice : {"99", "nonsense", "0x0"}) {
        const std::string message = refusal(choice);
        INFO(message);
        CHECK(contains(message, "SUNDER_EGL_DEVICE is '" + choice + "'"));
        for (const DeviceListEntry& entry : listDevices())
            CHECK(contains(message, entry.description));
    }
}

TEST_CASE("A device is chosen by its index and by its name") {
    for (const DeviceListEntry& entry : listDevices()) {
        if (!entry.usable || entry.index < 0) continue;
        INFO(entry.description);
        {
            const DeviceChoice chosen(std::to_string(entry.index));
            CHECK(createHeadlessContext()->info().device == entry.description);
        }
        std::string name = entry.info.renderer.substr(0, entry.info.renderer.find(' '));
        for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        const DeviceChoice chosen(name);
        const std::string renderer = createHeadlessContext()->info().renderer;
        CHECK(renderer.substr(0, name.size()) == entry.info.renderer.substr(0, name.size()));
    }
}

TEST_CASE("`software` gives a software device or none") {
    bool any = false;
    for (const DeviceListEntry& entry : listDevices()) any |= entry.usable && entry.info.software;
    const std::string message = refusal("software");
    INFO(message);
    CHECK(message.empty() == any);
    if (!any) return;
    const DeviceChoice chosen("software");
    CHECK(createHeadlessContext()->info().software);
}

TEST_CASE("An empty choice is no choice") {
    const DeviceChoice chosen("");
    CHECK_NOTHROW(createHeadlessContext());
}

#ifdef __linux__
// For the next test, in a process of its own: Mesa reads MESA_GL_VERSION_OVERRIDE once.
static const Command kMakeContext{"--make-context", [](const auto&) { createHeadlessContext(); }};

TEST_CASE("A driver below OpenGL 4.1 is refused with its version") {
    for (const DeviceListEntry& entry : listDevices())
        if (entry.usable && !contains(entry.info.version, "Mesa")) {
            WARN("not tested: " << entry.info.renderer << " is not Mesa's");
            return;
        }
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
    const TestFolder folder;
    const std::filesystem::path said = folder.path() / "said.txt";
    const std::string command =
        "MESA_GL_VERSION_OVERRIDE=4.0 '" + self + "' --make-context 2> '" + said.string() + "'";
    const int status = std::system(command.c_str());
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 1);
    std::string message;
    std::getline(std::ifstream(said), message);
    INFO(message);
    CHECK(contains(message, "the driver offers OpenGL 4.0, Sunder needs 4.1"));
}
#endif
