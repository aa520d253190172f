#pragma once
#include <functional>

namespace CLI {
class App;
}

namespace sunder::app {

/// Exit codes of the program.
enum ExitCode { kDone = 0, kDifferent = 1, kBadInput = 2, kNoContext = 3 };

/// Each adds its subcommand to the command line. When the user picks it, `chosen` becomes the
/// function to run.
using Action = std::function<int()>;
void addRun(CLI::App& app, Action& chosen);
void addView(CLI::App& app, Action& chosen);
void addBench(CLI::App& app, Action& chosen);
void addCompare(CLI::App& app, Action& chosen);
void addInfo(CLI::App& app, Action& chosen);
void addList(CLI::App& app, Action& chosen);

}  // namespace sunder::app
