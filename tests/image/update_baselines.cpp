// sunder_image_tests --update-baselines [--states] [NAME], for tools/update-baselines
#include <cstdlib>
#include <iostream>

#include "command.hpp"
#include "gpu/test_context.hpp"
#include "image/renewal.hpp"

using namespace sunder;
using namespace sunder::core;
namespace fs = std::filesystem;

namespace {

void updateBaselines(const std::vector<std::string>& arguments) {
    Renewal renewal{.ci = std::getenv("CI") != nullptr};
    for (const std::string& argument : arguments) {
        if (argument == "--states")
            renewal.states = true;
        else if (renewal.only.empty())
            renewal.only = argument;
        else
            throw InputError("at most one picture");
    }
    const TestContextOfCommand released;
    const fs::path folder = SUNDER_IMAGE_TESTS;
    const Suite suite = readSuite(folder / "suite.toml");
    for (const fs::path& path : renew(suite, folder, testContext().info(), renewal))
        std::cout << "wrote " << path.string() << '\n';
}

const Command kUpdateBaselines{"--update-baselines", updateBaselines};

}  // namespace
