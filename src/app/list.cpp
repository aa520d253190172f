#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>

#include "app/commands.hpp"
#include "scene/scene.hpp"
#include "sim_gl/solvers.hpp"

namespace sunder::app {
namespace {

template <class Entries>
void print(const char* heading, const Entries& entries) {
    std::cout << heading << '\n';
    for (const auto& entry : entries)
        std::cout << "  " << std::left << std::setw(20) << entry.name << entry.title << '\n';
}

int list() {
    print("Scenes", scene::scenePresets());
    print("Materials", scene::materialPresets());
    print("Solvers", sim_gl::solvers());
    return kDone;
}

}  // namespace

void addList(CLI::App& app, Action& chosen) {
    app.add_subcommand("list", "Scenes, materials and solvers")->callback([&] { chosen = list; });
}

}  // namespace sunder::app
