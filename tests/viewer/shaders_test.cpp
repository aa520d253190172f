// Shaders from a folder, which somebody works on while the viewer shows them.
#include <fstream>

#include "catch.hpp"
#include "pictures.hpp"
#include "viewer_under_test.hpp"

using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A copy of all shaders.
fs::path shadersFor(const Screen& screen) {
    const fs::path folder = screen.folder() / "glsl";
    fs::copy(SUNDER_SHADERS, folder, fs::copy_options::recursive);
    return folder;
}

/// Writes one of them, waits until the viewer has tried it, and returns what was wrong.
Json write(ViewerUnderTest& viewer, const fs::path& file, const std::string& text) {
    const std::size_t seen = viewer.eventCount("shaders");
    std::ofstream(file) << text;
    // Also where files have times of whole seconds.
    fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::seconds(seen));
    return viewer.nextEvent("shaders", seen)["error"];
}

}  // namespace

TEST_CASE(
    "A shader that changes is used at once, a mistake in it is shown, and the old one goes on",
    "[viewer]") {
    const Screen screen(900, 560);
    const fs::path shaders = shadersFor(screen), file = shaders / "draw" / "sky.frag";
    ViewerUnderTest viewer(
        screen, {"--size", "900x560", "--solver", "cpu", "--shader-dir", shaders.string()});
    viewer.key("space");
    viewer.pointAway();
    const sunder::image::Image before = viewer.keep("60-shaders");
    const std::string text = textOf(file);
    const Json error = write(viewer, file, text + "\nbroken\n");
    REQUIRE(error.is_string());
    CHECK_THAT(error.get<std::string>(), Catch::Contains("sky.frag"));
    const sunder::image::Image during = viewer.keep("61-shader-error");
    // The wall stands as it did, a panel says what is wrong.
    CHECK(difference(before, during, {450, 250, 300, 200}) < 0.01);
    CHECK(difference(before, during, {340, 10, 500, 60}) > 0.3);

    const std::size_t end = text.rfind('}');
    CHECK(write(viewer, file, text.substr(0, end) + "colour = vec4(1, 0, 0, 1);\n}\n").is_null());
    CHECK(share(viewer.keep("62-red-sky"), {600, 5, 290, 20}, 255, 0, 0) > 0.5);
    viewer.quit();
}

TEST_CASE("A mistake in a shader that is not in use is said when it would be", "[viewer]") {
    const Screen screen(900, 560);
    const fs::path shaders = shadersFor(screen);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x560", "--solver", "gather",
                                    "--shader-dir", shaders.string()});
    const auto goesOn = [&] {
        const Json now = viewer.freshStatus();
        return eventually([&] { return viewer.status()["time"] > now["time"]; });
    };
    const auto lastProblem = [&](std::size_t seen) {
        return viewer.nextEvent("problem", seen)["text"].get<std::string>();
    };
    // Of another solver.
    const fs::path scatter = shaders / "scatter" / "element.vert";
    const std::string sound = textOf(scatter);
    CHECK(write(viewer, scatter, sound + "\nbroken\n").is_null());
    viewer.click("solver.scatter");
    CHECK_THAT(lastProblem(0), Catch::Contains("scatter/element.vert"));
    viewer.keep("63-solver-with-a-mistake");
    CHECK(viewer.freshStatus()["solver"] == "gather");
    CHECK(goesOn());
    CHECK(write(viewer, scatter, sound).is_null());
    viewer.click("solver.scatter");
    CHECK(viewer.becomes("solver", "scatter"));
    CHECK(goesOn());

    // Of another scene: nothing of a wooden wall is transparent.
    const fs::path glass = shaders / "draw" / "transparent.frag";
    const std::string clear = textOf(glass);
    CHECK(write(viewer, glass, clear + "\nbroken\n").is_null());
    viewer.click("tab.wall");
    const std::size_t problems = viewer.eventCount("problem");
    viewer.click("scene");
    viewer.click("scene.glass");
    CHECK_THAT(lastProblem(problems), Catch::Contains("draw/transparent.frag"));
    viewer.keep("64-scene-with-a-mistake");
    CHECK(viewer.freshStatus()["scene"] == "wood");
    CHECK(goesOn());
    CHECK(write(viewer, glass, clear).is_null());
    viewer.click("scene");
    viewer.click("scene.glass");
    CHECK(viewer.becomes("scene", "glass"));
    viewer.quit();
}
