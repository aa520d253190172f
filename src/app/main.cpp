#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <new>

#include "app/commands.hpp"
#include "core/types.hpp"
#include "files/system.hpp"

namespace {

/// One sentence, and where to read more. CLI11 alone would say of a misspelt command only that one
/// is required.
std::string failureMessage(const CLI::App* app, const CLI::Error& error) {
    const auto commands = app->get_subcommands();
    const std::vector<std::string> unknown = app->remaining();
    std::string problem = error.what(), help = "sunder ";
    if (!commands.empty()) help += commands.front()->get_name() + " ";
    if (commands.empty() && !unknown.empty()) {
        problem = "there is no command '" + unknown.front() + "'; known:";
        const char* separator = " ";
        for (const CLI::App* known : app->get_subcommands({})) {
            problem += separator + known->get_name();
            separator = ", ";
        }
    }
    return "sunder: " + problem + " (see: " + help + "--help)\n";
}

}  // namespace

int main(int argc, char** argv) {
    using namespace sunder;
    const files::Console console;
    CLI::App app(
        "Sunder: walls that bend, crack and break, on the CPU and on any GPU with OpenGL 4.1.",
        "sunder");
    app.require_subcommand(1);
    app.failure_message(failureMessage);
    app::Action chosen;
    app::addRun(app, chosen);
    app::addView(app, chosen);
    app::addBench(app, chosen);
    app::addCompare(app, chosen);
    app::addInfo(app, chosen);
    app::addList(app, chosen);
    try {
        std::vector<std::string> words = files::commandLine(argc, argv);
        std::reverse(words.begin(), words.end());  // so CLI11 takes them
        app.parse(std::move(words));
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? app::kDone : app::kBadInput;
    }
    try {
        const int code = chosen();
        std::cout.flush();
        if (!std::cout)
            throw core::InputError("standard output cannot be written; is the disk full?");
        return code;
    } catch (const core::InputError& error) {
        std::cerr << "sunder: " << error.what() << '\n';
        return app::kBadInput;
    } catch (const core::DeviceError& error) {
        std::cerr << "sunder: " << error.what() << '\n';
        return app::kNoContext;
    } catch (const std::bad_alloc&) {
        std::cerr << "sunder: this machine has not enough memory for that; fewer cells or smaller "
                     "pictures need less\n";
        return app::kBadInput;
    } catch (const std::exception& error) {
        // A defect of ours or of the driver, not of the input; still one sentence.
        std::cerr << "sunder: internal error: " << error.what() << '\n';
        return app::kBadInput;
    }
}
