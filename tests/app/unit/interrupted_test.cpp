// A run that is asked to end by a signal and has made nothing yet.
#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"

#ifndef _WIN32

#include <csignal>

TEST_CASE("App: an interrupted run says so, its exit code tells by what, and nothing is left") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const Workplace place;
        place.write("wall.toml", scenes::kFalling);
        Result result;
        // A signal that comes before the first frame has nothing to be said of it.
        for (int delay = 50; result.err.empty(); delay *= 2) {
            REQUIRE(delay < 60000);
            RunningProgram program =
                place.start({"run", "wall.toml", "--solver", "cpu", "--frames", "1000000",
                             "--frames-png", "0", "--out", "deep/o"},
                            kNoGl);
            std::this_thread::sleep_for(std::chrono::milliseconds(delay));
            program.sendAll(signal);
            result = program.wait();
            CHECK(result.exitCode == 128 + signal);
            CHECK(place.contents() == std::set<std::string>{"wall.toml"});
        }
        checkRefused(result, 128 + signal,
                     {"interrupted after ", "of 1000000 frames: there is no report"});
    }
}

#endif
