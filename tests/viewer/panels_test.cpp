// What the panels beside a wall change: its material, its size, its colours, time.
#include <array>
#include <fstream>
#include <map>

#include "catch.hpp"
#include "pictures.hpp"
#include "viewer_under_test.hpp"

using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A field of a file that the viewer wrote.
double number(const std::string& toml, const std::string& key) {
    const std::size_t at = toml.find("\n" + key + " = ");
    INFO(toml);
    REQUIRE(at != std::string::npos);
    return std::stod(toml.substr(at + key.size() + 4));
}

/// What `sunder run` says of a scene's file after a few frames.
Json runs(const Screen& screen, const std::string& scene) {
    const fs::path json = screen.folder() / "run.json", said = screen.folder() / "run.txt";
    Child child({SUNDER_PROGRAM, "run", (screen.folder() / scene).string(), "--solver", "cpu",
                 "--frames", "9", "--frames-png", "0", "--out", (screen.folder() / "out").string(),
                 "--json", json.string()},
                {}, said);
    child.wait(120);
    INFO(textOf(said));
    REQUIRE(child.wait(0) == 0);
    return Json::parse(textOf(json));
}

}  // namespace

TEST_CASE("Time stops, steps, and runs slowly", "[viewer]") {
    const Screen screen(900, 560);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x560", "--solver", "cpu"});
    viewer.key("space");
    REQUIRE(viewer.becomes("paused", true));
    const double paused = viewer.freshStatus()["time"];
    CHECK(viewer.freshStatus()["time"] == paused);
    viewer.click("step");
    CHECK(viewer.freshStatus()["time"].get<double>() == Approx(paused + 1.0 / 60));
    viewer.key("comma");
    CHECK(viewer.freshStatus()["time"].get<double>() == Approx(paused + 1.0 / 60 + 1.0 / 3000));
    viewer.key("bracketleft");
    CHECK(viewer.status()["speed"] == 0.5);
    viewer.key("space");
    CHECK(viewer.becomes("paused", false));
    const Json first = viewer.freshStatus();
    CHECK(eventually([&] { return viewer.status()["time"] > first["time"]; }));
    viewer.click("restart");
    CHECK(eventually([&] { return viewer.status()["time"] < paused; }));
    viewer.quit();
}

TEST_CASE("A material is changed, tuned and saved, and what is saved runs to the same end",
          "[viewer]") {
    const Screen screen(900, 720);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x720", "--solver", "cpu"});
    viewer.clickScene(0.5, 0.45);
    REQUIRE(eventually([&] { return viewer.status()["bonds_broken"] > 20; }));
    viewer.click("tab.material");
    const sunder::image::Image wood = viewer.keep("30-wood");
    const Json before = viewer.freshStatus();
    viewer.click("material");
    viewer.keep("31-materials");
    viewer.click("material.concrete");
    REQUIRE(viewer.becomes("materials", Json::array({"concrete"})));
    // The wall goes on as it is: what was broken stays broken, time does not begin again.
    const Json after = viewer.freshStatus();
    CHECK(after["bonds_broken"] >= before["bonds_broken"]);
    CHECK(after["time"] >= before["time"]);
    const sunder::image::Image concrete = viewer.keep("32-concrete");
    checkLooksRight(concrete);
    CHECK(sceneDifference(wood, concrete) > 0.2);

    const std::size_t changes = viewer.eventCount("material");
    viewer.clickAt("damping", 0.3, 0.5);
    viewer.nextEvent("material", changes);
    CHECK(viewer.freshStatus()["time"] >= after["time"]);
    viewer.type("material_name", "mine");
    REQUIRE(eventually([&] { return viewer.eventCount("saved_material") == 1; }));
    CHECK(number(viewer.written("mine.toml"), "damping") != 1);

    viewer.click("tab.wall");
    viewer.type("scene_name", "scene");
    REQUIRE(eventually([&] { return viewer.eventCount("saved_scene") == 1; }));
    viewer.keep("33-saved");
    // The program reads both back.
    std::ofstream(screen.folder() / "with.toml")
        << "[[body]]\nname = \"wall\"\nmaterial = \"mine.toml\"\nsize = [3, 2, 0.1]\n"
           "cells = [30, 20, 1]\nanchor = [\"bottom\"]\n[[event]]\ntime = 0.1\nkind = "
           "\"velocity\"\nbody = \"wall\"\npoint = [0.2, 1.1, 0.05]\nradius = 0.3\nvector = [0, 0, "
           "-40]\n";
    const Json own = runs(screen, "scene.toml"), with = runs(screen, "with.toml");
    CHECK(own["bonds_broken"] > 0);
    CHECK(own["state_hash"] == with["state_hash"]);

    viewer.click("revert_scene");
    CHECK(viewer.becomes("materials", Json::array({"wood"})));
    viewer.quit();
}

TEST_CASE("What was changed of a material is typed, taken back, and saved over once agreed",
          "[viewer]") {
    const Screen screen(780, 720);
    ViewerUnderTest viewer(screen, {"wood", "--size", "780x720", "--solver", "cpu"});
    viewer.key("space");
    viewer.click("tab.material");
    // Each as it is written to a file of this name.
    const auto saved = [&] {
        const std::size_t seen = viewer.eventCount("saved_material");
        viewer.click("save_material");
        viewer.nextEvent("saved_material", seen);
        return viewer.written("mine.toml");
    };
    viewer.type("material_name", "mine");
    REQUIRE(eventually([&] { return viewer.eventCount("saved_material") == 1; }));
    const std::string opened = viewer.written("mine.toml");
    const double density = number(opened, "density");
    CHECK(density == 600);
    CHECK(number(opened, "young_modulus") == 10e9);

    const auto change = [&](auto&& act) {
        const std::size_t seen = viewer.eventCount("material");
        act();
        viewer.nextEvent("material", seen);
    };
    change([&] { viewer.typeNumber("density", "750"); });
    change([&] { viewer.clickAt("damping", 0.8, 0.5); });
    viewer.keep("34-tuned");
    std::string text = saved();
    CHECK(number(text, "density") == 750);
    CHECK(number(text, "damping") != number(opened, "damping"));
    // One number is taken back, the other stays; then all are.
    change([&] { viewer.clickAt("density", 0.5, 0.5, 3); });
    const std::string taken = saved();
    CHECK(number(taken, "density") == density);
    CHECK(number(taken, "damping") == number(text, "damping"));
    change([&] { viewer.click("revert"); });
    CHECK(saved() == opened);

    // A number is typed in the unit that is shown. One number of a direction leaves the others.
    viewer.click("group.young_modulus");
    viewer.click("group.max_stress");
    CHECK_THAT(opened, Catch::Contains("\nstrength = [4500000, 2.25e07, 4500000]\n"));
    viewer.keep("35-breaking");
    change([&] { viewer.typeNumber("strength.y", "9"); });
    CHECK_THAT(saved(), Catch::Contains("\nstrength = [4500000, 9000000, 4500000]\n"));
    viewer.click("group.max_stress");
    viewer.click("group.spread");
    viewer.keep("36-chunks-and-scatter");
    change([&] { viewer.typeNumber("spread", "0.1"); });
    CHECK(number(saved(), "spread") == 0.1);
    change([&] { viewer.click("clusters.voronoi"); });
    CHECK_THAT(saved(), Catch::Contains("\nclusters = \"voronoi\"\n"));

    // Somebody else's file is only replaced when that is asked for twice.
    const fs::path foreign = screen.folder() / "foreign.toml";
    std::ofstream(foreign) << "density = 1\n";
    const std::size_t files = viewer.eventCount("saved_material");
    const std::size_t problems = viewer.eventCount("problem");
    viewer.type("material_name", "foreign");
    CHECK_THAT(viewer.nextEvent("problem", problems)["text"].get<std::string>(),
               Catch::Contains("foreign.toml") && Catch::Contains("again"));
    CHECK(viewer.eventCount("saved_material") == files);
    CHECK(textOf(foreign) == "density = 1\n");
    viewer.keep("37-there-already");
    viewer.click("save_material");
    viewer.nextEvent("saved_material", files);
    CHECK(number(textOf(foreign), "spread") == 0.1);
    viewer.quit();
}

TEST_CASE("A stiffness that the step limits says so, where it bites", "[viewer]") {
    const Screen screen(900, 560);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x560", "--solver", "cpu"});
    viewer.key("space");
    viewer.click("tab.material");
    // The sentence stands between two sliders.
    const auto between = [&] {
        const auto above = viewer.place("young_modulus"), below = viewer.place("poisson_ratio");
        return Area{0, static_cast<int>(above[3]) + 1, kPanel,
                    static_cast<int>(below[1] - above[3]) - 2};
    };
    const Area limited = between();
    CHECK(share(viewer.keep("38-limited"), limited, 237, 143, 51) > 0.002);

    const std::size_t seen = viewer.eventCount("material");
    viewer.typeNumber("young_modulus", "0.005");  // GPa
    viewer.nextEvent("material", seen);
    viewer.pointAway();
    const Area free = between();
    CHECK(free.height < limited.height - 15);
    CHECK(share(viewer.keep("39-not-limited"), free, 237, 143, 51) == 0);

    viewer.clickAt("young_modulus", 0.5, 0.5, 3);
    viewer.nextEvent("material", seen + 1);
    viewer.freshStatus();
    CHECK(between().height == limited.height);
    viewer.quit();
}

TEST_CASE("A new wall has the size, the cells and the seed that were asked for", "[viewer]") {
    const Screen screen(900, 560);
    ViewerUnderTest viewer(screen, {"wood", "--size", "900x560", "--solver", "cpu"});
    viewer.clickScene(0.5, 0.45);
    REQUIRE(eventually([&] { return viewer.status()["bonds_broken"] > 20; }));
    viewer.click("tab.wall");
    viewer.pointAway();
    const sunder::image::Image before = viewer.keep("45-old-wall");
    const std::array<std::string, 3> sizes{"2", "1.5", "0.2"}, cells{"20", "15", "2"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double column = (static_cast<double>(axis) + 0.5) / 3;
        viewer.typeNumber("size", sizes[axis], column);
        viewer.typeNumber("cells", cells[axis], column);
    }
    viewer.type("seed", "77");
    // Nothing is built before it is asked for.
    CHECK(viewer.eventCount("build") == 0);
    CHECK(viewer.status()["bonds_broken"] > 20);
    viewer.click("build");
    REQUIRE(viewer.eventCount("build") == 1);
    CHECK(viewer.becomes("seed", 77));
    CHECK(viewer.becomes("bonds_broken", 0));
    viewer.pointAway();
    const sunder::image::Image after = viewer.keep("46-new-wall");
    checkLooksRight(after);
    CHECK(sceneDifference(before, after) > 0.1);

    viewer.type("scene_name", "smaller");
    REQUIRE(eventually([&] { return viewer.eventCount("saved_scene") == 1; }));
    const std::string text = viewer.written("smaller.toml");
    CHECK_THAT(text, Catch::Contains("\nsize = [2, 1.5, 0.2]\n"));
    CHECK_THAT(text, Catch::Contains("\ncells = [20, 15, 2]\n"));
    CHECK_THAT(text, Catch::Contains("seed = 77\n"));
    // Its middle is hit, and it breaks.
    viewer.key("5");
    CHECK(eventually([&] { return viewer.status()["bonds_broken"] > 20; }));

    viewer.click("new_seed");
    CHECK(viewer.becomes("seed", 78));
    CHECK(viewer.becomes("bonds_broken", 0));
    viewer.click("revert_scene");
    REQUIRE(viewer.eventCount("revert_scene") == 1);
    viewer.pointAway();
    CHECK(sceneDifference(after, viewer.keep("47-old-wall-again")) > 0.1);
    viewer.quit();
}

TEST_CASE("Colours that measure differ from each other, and say what they mean", "[viewer]") {
    const Screen screen(1280, 720);
    ViewerUnderTest viewer(screen, {"wood", "--size", "1280x720", "--solver", "cpu"});
    viewer.clickScene(0.5, 0.45);
    REQUIRE(eventually([&] { return viewer.status()["bonds_broken"] > 20; }));
    viewer.key("space");
    REQUIRE(viewer.becomes("paused", true));
    const auto shown = [&](const std::string& colour) {
        viewer.click("colour." + colour);
        viewer.pointAway();
        return viewer.keep("48-colours-" + colour);
    };
    std::map<std::string, sunder::image::Image> images;
    for (const std::string colour : {"Material", "Stress", "Speed", "Pieces"})
        images[colour] = shown(colour);
    for (auto a = images.begin(); a != images.end(); ++a)
        for (auto b = images.begin(); b != a; ++b) {
            INFO(a->first << " and " << b->first);
            CHECK(sceneDifference(a->second, b->second) > 0.05);
        }

    // A dark box with a scale of many colours, and letters; nothing that measures nothing has one.
    const Area legend{1280 - 16 - 230, 720 - 16 - 52, 230, 52};
    const auto letters = [&](const std::string& colour) {
        return share(images[colour], legend, 240, 240, 235);
    };
    for (const std::string colour : {"Stress", "Speed"}) {
        INFO(colour);
        CHECK(difference(images["Material"], images[colour], legend) > 0.9);
        CHECK(colours(images[colour], legend) > colours(images["Material"], legend) + 20);
        CHECK(letters(colour) > 0.001);
    }
    CHECK(difference(images["Stress"], images["Speed"], legend) > 0.01);
    // How many pieces there are needs no scale.
    CHECK(letters("Pieces") > 0.0005);
    CHECK(letters("Material") == 0);
    viewer.quit();
}
