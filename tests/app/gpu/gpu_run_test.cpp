// Good runs of `sunder run` and `sunder info` that need OpenGL: pictures, and the solver on the
// GPU.
#include "app/support/flying_objects.hpp"
#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"
#include "image/image.hpp"

using nlohmann::json;

namespace {

Result run(const Workplace& place, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"run", "wall.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Result result = place.run(arguments);
    INFO(result.command << "\nstderr: " << result.err);
    REQUIRE(result.exitCode == 0);
    return result;
}

json reportOf(const Workplace& place, const std::string& solver) {
    run(place, {"--frames-png", "0", "--solver", solver, "--json", "a.json"});
    return place.readJson("a.json");
}

/// More than one colour: something was drawn.
bool hasContrast(const sunder::image::Image& image) {
    for (std::size_t i = 3; i < image.pixels.size(); ++i)
        if (image.pixels[i] != image.pixels[i % 3]) return true;
    return false;
}

}  // namespace

TEST_CASE("App: pictures are those that were asked for, in the size that was asked for") {
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    const Result result = run(place, {"--frames-png", "2", "--size", "160x90", "--out", "o"});
    CHECK(contains(result.out, "o/report.json"));
    CHECK(place.contents() == std::set<std::string>{"o", "o/frame_0000.png", "o/frame_0002.png",
                                                    "o/frame_0004.png", "o/frame_0005.png",
                                                    "o/report.json", "wall.toml"});
    const sunder::image::Image first = sunder::image::readPng(place.path("o/frame_0000.png"));
    const sunder::image::Image last = sunder::image::readPng(place.path("o/frame_0005.png"));
    for (const sunder::image::Image& image : {first, last}) {
        CHECK(image.width == 160);
        CHECK(image.height == 90);
        CHECK(hasContrast(image));
    }
    CHECK(first.pixels != last.pixels);
    const json report = place.readJson("o/report.json");
    CHECK(report.at("solver") == "gather");  // the default
    CHECK(report.at("gl_renderer").get<std::string>() != "");
    CHECK(report.at("bonds_broken") > 0);
}

TEST_CASE("App: a run over an earlier one's folder replaces what it writes") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    run(place, {"--frames-png", "5", "--size", "160x90", "--out", "o"});
    const std::set<std::string> before = place.contents();
    const std::string report = place.read("o/report.json");
    run(place, {"--frames-png", "5", "--out", "o", "--size", "96x64", "--seed", "9"});
    CHECK(place.contents() == before);  // no temporary file either
    for (const std::string frame : {"o/frame_0000.png", "o/frame_0005.png"}) {
        const sunder::image::Image image = sunder::image::readPng(place.path(frame));
        CHECK(image.width == 96);
        CHECK(image.height == 64);
    }
    CHECK(place.read("o/report.json") != report);
    CHECK(place.readJson("o/report.json").at("seed") == 9);
}

TEST_CASE("App: the GPU solvers and reference tell the same of a wall that falls") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    const std::string name = GENERATE("scatter", "gather");
    const json gpu = reportOf(place, name), reference = reportOf(place, "reference");
    CHECK(gpu.at("solver") == name);
    CHECK(reference.at("solver") == "reference");
    for (const char* key : {"cells", "tetrahedra", "nodes", "bonds_total", "bonds_broken", "pieces",
                            "frames", "dt", "steps_per_frame", "nan"}) {
        INFO(key);
        CHECK(gpu.at(key) == reference.at(key));
    }
    CHECK(gpu.at("min_y").get<double>() ==
          Approx(reference.at("min_y").get<double>()).margin(1e-3));
    CHECK(gpu.at("max_speed").get<double>() ==
          Approx(reference.at("max_speed").get<double>()).epsilon(1e-3));
    CHECK(gpu.at("energy").at("kinetic").get<double>() ==
          Approx(reference.at("energy").at("kinetic").get<double>()).epsilon(1e-3));
}

TEST_CASE("App: a GPU solver gives the same wall twice, and another for another seed") {
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    const std::string solver = GENERATE("scatter", "gather");
    const auto hash = [&](const std::string& seed) -> std::string {
        run(place, {"--frames-png", "0", "--solver", solver, "--seed", seed, "--json", "a.json"});
        CHECK(place.readJson("a.json").at("nan") == 0);
        return place.readJson("a.json").at("state_hash");
    };
    const std::string once = hash("7");
    CHECK(hash("7") == once);
    CHECK(hash("8") != once);
}

TEST_CASE("App: auto says how many bodies the GPU has") {
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    const json report = reportOf(place, "auto");
    CHECK(report.at("solver") == "auto");
    CHECK(report.at("bodies_on_gpu") >= 0);
    CHECK(report.at("bodies_on_gpu") <= 1);
    CHECK(report.at("bonds_broken") > 0);
    CHECK(!reportOf(place, "gather").contains("bodies_on_gpu"));
}

TEST_CASE("App: every solver takes a scene with contact and something thrown") {
    const Workplace place;
    place.write("wall.toml", std::string(scenes::kFalling) + R"(
[[object]]
name = "ball"
shape = "sphere"
radius = 0.1
mass = 5
[[event]]
kind = "throw"
time = 0
object = "ball"
from = [0, 1, 2]
velocity = [0, 0, -9]
)");
    for (const std::string solver : {"gather", "scatter", "auto", "cpu", "reference"}) {
        INFO(solver);
        const nlohmann::json report = reportOf(place, solver);
        // 5 kg at 9 m/s, less the drag.
        CHECK(report.at("momentum")[2] < -40);
        CHECK(report.at("nan") == 0);
    }
}

TEST_CASE("App: the report of a GPU solver has every object's state as free flight has it") {
    const Workplace place;
    place.write("wall.toml", flying::scene());
    for (const std::string solver : {"gather", "scatter", "auto"}) {
        INFO(solver);
        flying::check(reportOf(place, solver));
    }
}

TEST_CASE("App: contacts that found no room are in the report as they are on stderr") {
    const Workplace place;
    // The search's voxels have the size of the large cells, and there is room for twelve spheres in
    // each: a hundred of the small ones are in it.
    place.write("wall.toml", R"(
frames = 5
[[body]]
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
)");
    for (const std::string solver : {"gather", "scatter", "cpu"}) {
        INFO(solver);
        const Result result =
            run(place, {"--frames-png", "0", "--solver", solver, "--json", "a.json"});
        const json lost = place.readJson("a.json").at("lost").at("contacts");
        CHECK((lost > 0) == (solver != "cpu"));
        const std::string said = "sunder: note: up to " + lost.dump() + " contacts at a time";
        CHECK(contains(result.err, said) == (lost > 0));
    }
}

TEST_CASE("App: without OpenGL 4.1 one sentence and exit code 3, and nothing is left") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    // Mesa's drivers obey this; another would not.
    const Result result =
        place.run({"run", "wall.toml", "--out", "o", "--json", "a.json"},
                  {{"MESA_GL_VERSION_OVERRIDE", "4.0"}, {"SUNDER_EGL_DEVICE", "software"}});
    checkRefused(result, 3, {"OpenGL 4.0", "needs 4.1"});
    CHECK(place.contents() == std::set<std::string>{"wall.toml"});
}

TEST_CASE("App: the solver compute without OpenGL 4.3 is refused, and gather named instead") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    const Workplace::Environment old{{"MESA_GL_VERSION_OVERRIDE", "4.1"},
                                     {"SUNDER_EGL_DEVICE", "software"}};
    const Result result = place.run({"run", "wall.toml", "--solver", "compute", "--out", "o"}, old);
    checkRefused(result, 2, {"compute needs OpenGL 4.3", "4.1", "use the solver gather"});
    CHECK(place.contents() == std::set<std::string>{"wall.toml"});
    CHECK(place.run({"run", "wall.toml", "--solver", "gather", "--out", "o"}, old).exitCode == 0);
}

TEST_CASE("App: --out that is a file is refused also where pictures are wanted") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    place.write("taken", "mine");
    const Result result = place.run({"run", "wall.toml", "--out", "taken", "--json", "a.json"});
    checkRefused(result, 2, {"'taken'"});
    CHECK(place.contents() == std::set<std::string>{"taken", "wall.toml"});
    CHECK(place.read("taken") == "mine");
}

TEST_CASE("App: info names the devices and the one that is picked") {
    const Workplace place;
    const Result result = place.run({"info", "--json", "info.json"});
    CHECK(result.exitCode == 0);
    CHECK(result.err.empty());
    const json report = place.readJson("info.json");
    const json& picked = report.at("picked");
    const std::string renderer = picked.at("gl_renderer"), device = picked.at("device");
    CHECK(contains(result.out, "Sunder uses " + renderer));
    CHECK(picked.at("max_texture_size") >= 1024);  // the least that OpenGL 4.1 allows
    CHECK(picked.at("max_transform_feedback_components") >= 64);
    int matching = 0;
    for (const json& entry : report.at("devices"))
        if (entry.at("description") == device && entry.at("usable") == true &&
            entry.at("gl_renderer") == renderer)
            ++matching;
    CHECK(matching == 1);
}
