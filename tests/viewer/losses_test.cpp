// What a solver leaves out is said in the window, too.
#include <fstream>

#include "catch.hpp"
#include "viewer_under_test.hpp"

TEST_CASE("Contacts that find no room are said once, and by the solvers that lose them",
          "[viewer]") {
    const Screen screen(800, 500);
    const std::string scene = (screen.folder() / "crowd.toml").string();
    // As in tests/app/gpu/gpu_run_test.cpp: a hundred small spheres where there is room for twelve.
    std::ofstream(scene) << R"([[body]]
name = "large"
material = "concrete"
size = [2, 1, 1]
cells = [2, 1, 1]
[[body]]
name = "fine"
material = "wood"
size = [1, 0.5, 0.1]
cells = [20, 10, 2]
position = [0, 0, 0.6]
)";
    ViewerUnderTest viewer(screen, {scene, "--size", "800x500", "--solver", "cpu"});
    const auto said = [&] {
        int count = 0;
        for (const nlohmann::json& message : viewer.events("message"))
            count += message["text"].get<std::string>().find("found no room") != std::string::npos;
        return count;
    };
    REQUIRE(eventually([&] { return viewer.status()["time"] > 0.1; }));
    CHECK(said() == 0);
    viewer.click("solver.gather");
    CHECK(eventually([&] { return said() > 0; }));
    viewer.freshStatus();
    CHECK(said() == 1);
    viewer.keep("80-contacts-left-out");
    viewer.quit();
}
