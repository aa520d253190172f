// `sunder bench` where no OpenGL can be had. What it measures is never compared with a time.
#include "app/support/bench_report.hpp"
#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"

using nlohmann::json;

TEST_CASE("App: bench without OpenGL measures the CPU solvers and says so in one sentence") {
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    const Result result = place.run({"bench", "wall.toml", "--quick", "--json", "a.json"}, kNoGl);
    INFO(result.command << "\nstderr: " << result.err);
    REQUIRE(result.exitCode == 0);
    CHECK(contains(result.err, "CPU solvers only"));
    CHECK(result.err.find('\n') == result.err.size() - 1);
    CHECK(contains(result.out, "no OpenGL"));
    CHECK(contains(result.out, "worst / median"));
    const json report = place.readJson("a.json");
    checkBenchResults(report, 5 * scenes::kCells, 50);
    CHECK(report.at("gl_renderer") == "");
    CHECK(report.at("passes").empty());
    bool reference = false;
    for (const json& entry : report.at("results")) {
        reference |= entry.at("solver") == "reference";
        CHECK(entry.at("solver") != "gather");
        CHECK(entry.at("ms_per_frame_drawn").is_null());
        const bool watched = entry.at("part") == "frames" && entry.at("solver") == "cpu";
        if (watched) CHECK(entry.at("ms_per_frame_worst").is_number());
    }
    CHECK(reference);
}

TEST_CASE("App: bench --walls puts copies of the first body into a grid") {
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    const Result result = place.run({"bench", "wall.toml", "--quick", "--walls", "3", "--solvers",
                                     "reference", "--repeats", "1", "--json", "a.json"},
                                    kNoGl);
    INFO(result.err);
    REQUIRE(result.exitCode == 0);
    const json report = place.readJson("a.json");
    checkBenchResults(report, 3 * 5 * scenes::kCells, 50);
    for (const json& entry : report.at("results")) {
        CHECK(entry.at("bodies") == 3);
        CHECK(entry.at("solver") == "reference");
        CHECK(entry.at("runs") == 1);
    }
}

TEST_CASE("App: bench measures a threaded solver once for each number of threads") {
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    const Result result =
        place.run({"bench", "wall.toml", "--quick", "--solvers", "cpu,reference", "--threads",
                   "1,3", "--repeats", "1", "--json", "a.json", "--svg", "a.svg"},
                  kNoGl);
    INFO(result.err);
    REQUIRE(result.exitCode == 0);
    const json report = place.readJson("a.json");
    checkBenchResults(report, 5 * scenes::kCells, 50);
    std::set<std::string> lines;
    for (const json& entry : report.at("results"))
        if (entry.at("part") == "frames")
            lines.insert(entry.at("solver").get<std::string>() + entry.at("threads").dump());
    CHECK(lines == std::set<std::string>{"cpu1", "cpu3", "reference1"});
    for (const char* label : {"cpu, 1 thread", "cpu, 3 threads"}) {
        CHECK(contains(result.out, label));
        CHECK(contains(place.read("a.svg"), label));
    }
}

TEST_CASE("App: bench refuses in one sentence, before it measures") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    struct Case {
        std::vector<std::string> arguments;
        int exitCode;
        std::vector<std::string> said;
    };
    const std::vector<Case> cases{
        {{"--solvers", "magic"},
         2,
         {"--solvers", "'magic'", "gather", "scatter", "cpu", "reference"}},
        {{"--solvers", "reference,magic"}, 2, {"'magic'", "known: "}},
        {{"--solvers", "reference,gather"}, 3, {}},
        {{"--walls", "0"}, 2, {"--walls"}},
        {{"--repeats", "0"}, 2, {"--repeats"}},
        {{"--threads", "0"}, 2, {"--threads"}},
        {{"--threads", "1,two"}, 2, {"--threads"}},
        {{"--json", "none/a.json"}, 2, {"none/a.json", "no folder 'none'"}},
        {{"--svg", "."}, 2, {"it is a folder"}},
    };
    for (const Case& c : cases) {
        std::vector<std::string> arguments{"bench", "wall.toml", "--quick"};
        arguments.insert(arguments.end(), c.arguments.begin(), c.arguments.end());
        checkRefused(place.run(arguments, kNoGl), c.exitCode, c.said);
        CHECK(place.contents() == std::set<std::string>{"wall.toml"});
    }
    checkRefused(place.run({"bench", "walls"}, kNoGl), 2, {"'walls'"});
}
