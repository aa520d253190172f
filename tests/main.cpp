#include <exception>
#include <iostream>
#include <map>

#if __has_include(<catch2/catch_session.hpp>)
#include <catch2/catch_session.hpp>
#else
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#endif

#include "command.hpp"

namespace {

std::map<std::string, Command::Run>& commands() {
    static std::map<std::string, Command::Run> all;
    return all;
}

}  // namespace

Command::Command(const std::string& option, Run run) {
    commands()[option] = run;
}

int main(int argc, char** argv) {
    const auto command = argc > 1 ? commands().find(argv[1]) : commands().end();
    if (command == commands().end()) return Catch::Session().run(argc, argv);
    try {
        command->second({argv + 2, argv + argc});
        return 0;
    } catch (const std::exception& error) {
        std::cerr << argv[1] << ": " << error.what() << '\n';
        return 1;
    }
}
