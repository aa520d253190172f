// Worlds at the limits of what a scene may ask for, on the GPU: a result, or one sentence.
#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"
#include "image/image.hpp"

TEST_CASE("App: one cell and a bar of 4,000 are simulated on the GPU, all numbers finite",
          "[long]") {
    const std::pair<const char*, const char*> walls[] = {
        {"[0.1, 0.1, 0.1]", "[1, 1, 1]"},
        {"[400, 0.1, 0.1]", "[4000, 1, 1]"},
    };
    for (const auto& [size, cells] : walls)
        for (const std::string solver : {"gather", "scatter"}) {
            const Workplace place;
            place.write("ok.toml", scenes::wall(size, cells));
            const Result result = place.run({"run", "ok.toml", "--solver", solver, "--size",
                                             "160x90", "--frames-png", "1", "--out", "o"});
            INFO(result.command << "\nstderr: " << result.err);
            REQUIRE(result.exitCode == 0);
            const auto report = place.readJson("o/report.json");
            CHECK(report.at("nan") == 0);
            CHECK(report.at("pieces") == 1);
            CHECK(report.at("max_speed") > 0);
        }
}

TEST_CASE("App: two million tetrahedra are simulated and drawn on the GPU, and hang together",
          "[long]") {
    const Workplace place;
    place.write("large.toml", scenes::kTwoMillion);
    const Result result = place.run({"run", "large.toml", "--solver", "gather", "--size", "160x90",
                                     "--frames-png", "1", "--out", "o"});
    INFO(result.command << "\nstderr: " << result.err);
    REQUIRE(result.exitCode == 0);
    const auto report = place.readJson("o/report.json");
    CHECK(report.at("tetrahedra") == 2'000'000);
    CHECK(report.at("nan") == 0);
    CHECK(report.at("pieces") == 1);
    CHECK(sunder::image::readPng(place.path("o/frame_0001.png").string()).width == 160);
}

// Sanitizers take terabytes of addresses for themselves; macOS does not limit them. Hardware has
// memory of its own.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE("App: a world beyond the software device's memory is refused, and leaves nothing") {
    const Workplace place;
    place.write("large.toml", scenes::wall("[50, 40, 0.2]", "[1000, 500, 2]"));
    // Half of it is the device's, a few hundred megabytes too few; the world and the program, with
    // threads for many cores, take less than the other half.
    checkRefused(place.runWithMemoryUpTo(2'000'000,
                                         {"run", "large.toml", "--solver", "gather", "--out", "o"},
                                         {{"SUNDER_EGL_DEVICE", "software"}}),
                 2, {"the device has no memory for the", "use fewer cells"});
    CHECK(place.contents() == std::set<std::string>{"large.toml"});
}
#endif
