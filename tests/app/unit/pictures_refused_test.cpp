// What `sunder run` refuses about videos and sheets before anything is simulated or drawn.
#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"

namespace {

/// No program can be found.
Workplace::Environment nothingInstalled() {
    Workplace::Environment environment = kNoGl;
    environment["PATH"] = "/nowhere";
    return environment;
}

}  // namespace

TEST_CASE("App: --video without ffmpeg is one sentence and exit code 2") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    for (const std::string solver : {"gather", "cpu"}) {
        const Result result = place.run({"run", "wall.toml", "--solver", solver, "--video",
                                         "wall.mp4", "--json", "a.json", "--out", "o"},
                                        nothingInstalled());
        checkRefused(result, 2,
                     {"a video needs ffmpeg, which is not installed;", "--frames-png 1"});
        CHECK(place.contents() == std::set<std::string>{"wall.toml"});
    }
}

TEST_CASE("App: sheets and colours that cannot be are one sentence and exit code 2") {
    struct Case {
        std::vector<std::string> options, said;
    };
    const std::vector<Case> cases{
        {{"--contact-sheet", "a.jpg"}, {"--contact-sheet", "'a.jpg'", ".png"}},
        {{"--contact-sheet", "none/a.png"}, {"no folder 'none'"}},
        {{"--contact-sheet", "."}, {"it is a folder"}},
        {{"--video", "none/a.mp4"}, {"no folder 'none'"}},
        {{"--sheet-times", "0.05"}, {"--sheet-times", "--contact-sheet"}},
        {{"--contact-sheet", "a.png", "--sheet-times", "0.05,5"},
         {"--sheet-times", "5 s is not within", "0.0833333 s"}},
        {{"--contact-sheet", "a.png", "--sheet-times", "-1"}, {"--sheet-times", "-1 s"}},
        {{"--contact-sheet", "a.png", "--sheet-times", "nan"}, {"--sheet-times", "nan s"}},
        {{"--contact-sheet", "a.png", "--sheet-times", "soon"}, {"--sheet-times", "soon"}},
        {{"--colour", "red"}, {"--colour", "stress", "speed", "piece"}},
    };
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    for (const Case& c : cases) {
        std::vector<std::string> arguments{"run", "wall.toml"};
        arguments.insert(arguments.end(), c.options.begin(), c.options.end());
        checkRefused(place.run(arguments, kNoGl), 2, c.said);
        CHECK(place.contents() == std::set<std::string>{"wall.toml"});
    }
}
