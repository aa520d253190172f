// Results that could not be written where they are wanted: refused before any work, and nothing is
// left.
#include <csignal>
#include <cstdlib>

#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"
#include "image/image.hpp"

namespace {

namespace fs = std::filesystem;

struct Place {
    std::string path, said;
};

/// Where no file can be, for anybody: root minds no permissions.
std::vector<Place> badFiles(const std::string& ending) {
    std::vector<Place> places{
        {"none/a" + ending, "no folder 'none'"},
        {"file/a" + ending, "'file' is not a folder"},
        {"folder" + ending, "it is a folder"},
        {std::string(300, 'a') + ending, "cannot be written: "},
    };
#ifdef __linux__
    places.push_back({"/proc/a" + ending, "/proc/a" + ending + ": cannot be written: "});
#endif
    return places;
}

void prepare(const Workplace& place) {
    place.write("wall.toml", scenes::kFalling);
    place.write("file", "mine");
    for (const std::string ending : {".json", ".vtu", ".png", ".mp4", ".svg"})
        fs::create_directory(place.path("folder" + ending));
    sunder::image::writePng(place.path("a.png"), {1, 1, {1, 2, 3}});
}

/// Refused before a context is asked for, which none of these runs could get (kNoGl): that would be
/// exit code 3.
void checkRefusedAt(const Workplace& place, std::vector<std::string> arguments,
                    const std::string& option, const Place& where) {
    arguments.insert(arguments.end(), {option, where.path});
    const std::set<std::string> before = place.contents();
    checkRefused(place.run(arguments, kNoGl), 2, {where.said});
    CHECK(place.contents() == before);
    CHECK(place.read("file") == "mine");
}

}  // namespace

TEST_CASE("App: a file that cannot be written is refused before the run, and nothing is left") {
    const Workplace place;
    prepare(place);
    const std::vector<std::string> run{"run", "wall.toml", "--out", "deep/o"};
    const std::vector<std::string> bench{"bench", "wall.toml", "--quick", "--solvers", "gather"};
    const std::vector<std::string> compare{"compare", "a.png", "a.png"};
    struct Case {
        std::vector<std::string> arguments;
        std::string option, ending;
    };
    for (const Place& where : badFiles(".json")) checkRefusedAt(place, run, "--json", where);
    // All go the same way: one place each tells whether they do.
    for (const Case& c : {Case{run, "--state", ".vtu"}, Case{run, "--contact-sheet", ".png"},
                          Case{run, "--video", ".mp4"}, Case{bench, "--json", ".json"},
                          Case{bench, "--svg", ".svg"}, Case{compare, "--json", ".json"},
                          Case{compare, "--diff", ".png"}, Case{{"info"}, "--json", ".json"}})
        checkRefusedAt(place, c.arguments, c.option, badFiles(c.ending).back());
}

TEST_CASE("App: a folder that cannot be made or written to is refused before the run") {
    const Workplace place;
    prepare(place);
    fs::create_directories(place.path("taken/report.json"));
    fs::create_directories(place.path("frames/frame_0004.png"));
    std::vector<Place> places{
        {"file", "--out: cannot make the folder 'file'"},
        {"new/folders/" + std::string(300, 'a'), "--out: cannot make the folder 'new/folders/"},
        {"file/below", "--out: cannot make the folder 'file"},
        {"taken", "report.json: cannot be written: it is a folder"},
        {"frames", "frame_0004.png: cannot be written: it is a folder"},
    };
#ifdef __linux__
    places.push_back({"/proc", "/proc/report.json: cannot be written: "});
    places.push_back({"/proc/o", "--out: cannot make the folder '/proc/o'"});
#endif
    for (const Place& where : places)
        checkRefusedAt(place, {"run", "wall.toml", "--frames-png", "2"}, "--out", where);
}

#ifndef _WIN32
TEST_CASE("App: a folder without permission to write is refused before the run") {
    const Workplace place;
    prepare(place);
    fs::create_directory(place.path("shut"));
    fs::permissions(place.path("shut"), fs::perms::owner_read | fs::perms::owner_exec);
    // Root may do it all the same: the file is tried, not the permission.
    std::error_code error;
    fs::create_directory(place.path("shut/x"), error);
    const bool allowed = !error;
    fs::remove(place.path("shut/x"), error);
    for (const std::string option : {"--out", "--json"}) {
        const std::string path = option == "--out" ? "shut" : "shut/a.json";
        const Result result = place.run(
            {"run", "wall.toml", "--solver", "cpu", "--frames-png", "0", option, path}, kNoGl);
        CHECK(result.exitCode == (allowed ? 0 : 2));
        CHECK(contains(result.err, "cannot be written: ") != allowed);
    }
    fs::permissions(place.path("shut"), fs::perms::owner_all);
}
#endif

TEST_CASE("App: two results under one name are refused, for one would be lost") {
    const Workplace place;
    prepare(place);
    const std::set<std::string> before = place.contents();
    checkRefused(place.run({"run", "wall.toml", "--json", "a", "--state", "./a"}, kNoGl), 2,
                 {"--json and --state both write to './a'"});
    checkRefused(place.run({"bench", "wall.toml", "--json", "a", "--svg", "a"}, kNoGl), 2,
                 {"--json and --svg both write to 'a'"});
    checkRefused(place.run({"compare", "a.png", "a.png", "--json", "b", "--diff", "b"}, kNoGl), 2,
                 {"--json and --diff both write to 'b'"});
    CHECK(place.contents() == before);
}

#ifndef _WIN32
TEST_CASE("App: a run does not write into the folder of another, which may have it afterwards") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    REQUIRE(std::system(("mkfifo '" + place.path("pipe").string() + "'").c_str()) == 0);
    const std::vector<std::string> second{"run",   "wall.toml", "--solver",     "cpu",
                                          "--out", "./o",       "--frames-png", "0"};
    std::vector<std::string> waiting = second;
    waiting.insert(waiting.end(), {"--json", "pipe"});
    // Once its first report is there, it waits for a reader of the second.
    RunningProgram first = place.start(waiting, kNoGl);
    REQUIRE(eventually([&] { return fs::exists(place.path("o/report.json")); }));
    const std::string report = place.read("o/report.json");
    checkRefused(place.run(second, kNoGl), 2,
                 {"--out: another `sunder run` is writing into './o'", "a folder of its own"});
    CHECK(place.read("o/report.json") == report);
    REQUIRE(first.running());
    // Nothing is lost any more, so the first signal ends it.
    first.send(SIGINT);
    CHECK(first.wait().exitCode == 130);
    CHECK(place.run(second, kNoGl).exitCode == 0);
    CHECK(place.contents() == std::set<std::string>{"o", "o/report.json", "pipe", "wall.toml"});
}
#endif
