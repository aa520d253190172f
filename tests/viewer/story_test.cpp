// A person at the viewer: real windows, a real mouse, a real keyboard.
#include <fstream>
#include <random>

#include "catch.hpp"
#include "viewer_under_test.hpp"

using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr int kPanel = 340;  // pixels, at scale 1

/// The panel is there, with its coloured headings, and the scene beside it is no plain area.
void checkLooksRight(const sunder::Image& image, int panel = kPanel) {
    CHECK(share(image, 0, 0, panel, image.height, 27, 28, 32) > 0.3);
    CHECK(share(image, 0, 0, panel, image.height, 237, 143, 51) > 0.0005);
    CHECK(colours(image, panel, 0, image.width - panel, image.height) > 30);
}

double sceneDifference(const sunder::Image& a, const sunder::Image& b) {
    return difference(a, b, kPanel, 0, a.width - kPanel, a.height - 60);
}

/// Pixels of `picture` that are not those of the window at `left`, `top`, leaving out its lowest
/// rows, where a hint is.
double windowDifference(const sunder::Image& window, int left, int top,
                        const sunder::Image& picture, int rows) {
    std::int64_t wrong = 0;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c)
                wrong += window.pixels[3 * (std::size_t(y + top) * window.width + x + left) + c] !=
                         picture.pixels[3 * (std::size_t(y) * picture.width + x) + c];
    return static_cast<double>(wrong) / (3.0 * picture.width * rows);
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(SUNDER_PRESETS "/scenes"))
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

TEST_CASE("A click on the wall breaks it, with every solver", "[viewer]") {
    const Screen screen(1280, 720);
    ViewerUnderTest viewer(screen, {"wood", "--size", "1280x720", "--solver", "cpu"});
    const sunder::Image whole = viewer.keep("01-wood-at-rest");
    checkLooksRight(whole);
    CHECK(viewer.status()["bonds_broken"] == 0);

    viewer.clickScene(0.5, 0.45);
    REQUIRE(viewer.eventCount("hit") == 1);
    CHECK(eventually([&] { return viewer.status()["bonds_broken"] > 20; }));
    const sunder::Image broken = viewer.keep("02-wood-hit");
    CHECK(sceneDifference(whole, broken) > 0.005);

    for (const char* solver : {"scatter", "auto", "reference", "gather", "cpu"}) {
        INFO(solver);
        const int before = viewer.freshStatus()["bonds_broken"];
        viewer.click(std::string("solver.") + solver);
        REQUIRE(viewer.becomes("solver", solver));
        // The state is kept: what is broken stays broken.
        CHECK(viewer.freshStatus()["bonds_broken"] >= before);
        CHECK(viewer.status()["nan"] == 0);
    }
    CHECK(viewer.eventCount("restart") == 0);
    const int before = viewer.freshStatus()["bonds_broken"];
    viewer.key("9");
    CHECK(eventually([&] { return viewer.status()["bonds_broken"] > before; }));
    viewer.key("r");
    CHECK(viewer.becomes("bonds_broken", 0));
    viewer.quit();
}

TEST_CASE("Every way of looking at a wall shows something else", "[viewer]") {
    const Screen screen(1280, 720);
    ViewerUnderTest viewer(screen, {"wood", "--size", "1280x720", "--solver", "cpu"});
    viewer.click("pause");
    REQUIRE(viewer.becomes("paused", true));
    screen.act("mousemove 1270 10");  // no ring on the wall
    const sunder::Image solid = viewer.keep("10-solid");
    const auto check = [&](const std::string& widget, const std::string& name, double least) {
        INFO(widget);
        viewer.click(widget);
        screen.act("mousemove 1270 10");
        const sunder::Image image = viewer.keep(name);
        checkLooksRight(image);
        CHECK(sceneDifference(solid, image) > least);
    };
    check("style.Wireframe", "11-wireframe", 0.05);
    check("style.Both", "12-both", 0.02);
    // At rest both meshes are the same wall; their edges tell them apart.
    const sunder::Image both = viewer.keep("13-both");
    viewer.click("mesh.Simulation");
    screen.act("mousemove 1270 10");
    CHECK(sceneDifference(both, viewer.keep("13-simulation-mesh")) > 0.02);
    viewer.click("mesh.Display");
    viewer.click("style.Solid");
    check("colour.Stress", "14-stress", 0.1);
    check("colour.Speed", "15-speed", 0.1);
    check("colour.Pieces", "16-pieces", 0.1);
    viewer.click("colour.Material");
    check("samples.4x", "17-samples", 0.0005);
    CHECK(viewer.status()["samples"] == 4);
    viewer.click("samples.Off");
    screen.act("mousemove 1270 10");
    CHECK(sceneDifference(solid, viewer.keep("18-as-before")) < 0.0005);
    viewer.click("vsync");
    CHECK(viewer.eventCount("vsync") == 1);

    viewer.key("F1");
    const sunder::Image help = viewer.keep("19-help");
    CHECK(sceneDifference(solid, help) > 0.2);
    viewer.key("F1");
    viewer.click("tab.measure");
    viewer.click("pause");
    const sunder::Image plots = viewer.keep("20-measure");
    CHECK(difference(solid, plots, 0, 150, kPanel, 500) > 0.05);
    screen.act("mousemove 150 500 click --repeat 30 5");
    CHECK(eventually([&] { return viewer.status()["widgets"].contains("plot.shadows"); }));
    viewer.keep("21-passes");

    // The camera, by mouse, wheel and keys, and back.
    viewer.click("tab.play");
    viewer.click("pause");
    screen.act("mousemove 1200 100 mousedown 3 mousemove_relative -- -150 0");
    viewer.freshStatus();
    screen.act("mouseup 3");
    const sunder::Image turned = viewer.keep("21-turned");
    CHECK(sceneDifference(solid, turned) > 0.1);
    screen.act("click 4 click 4 click 4");
    CHECK(sceneDifference(turned, viewer.keep("22-nearer")) > 0.1);
    screen.act("keydown w");
    viewer.freshStatus();
    screen.act("keyup w");
    viewer.key("Home");
    screen.act("mousemove 1270 10");
    CHECK(sceneDifference(solid, viewer.keep("23-home")) < 0.0005);
    viewer.quit();
}

TEST_CASE("Time stops, steps, and runs slowly", "[viewer]") {
    const Screen screen(1000, 600);
    ViewerUnderTest viewer(screen, {"wood", "--size", "1000x600", "--solver", "cpu"});
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
    const Screen screen(1280, 720);
    ViewerUnderTest viewer(screen, {"wood", "--size", "1280x720", "--solver", "cpu"});
    viewer.clickScene(0.5, 0.45);
    REQUIRE(eventually([&] { return viewer.status()["bonds_broken"] > 20; }));
    viewer.click("tab.material");
    const sunder::Image wood = viewer.keep("30-wood");
    const Json before = viewer.freshStatus();
    viewer.click("material");
    viewer.click("material.concrete");
    REQUIRE(viewer.becomes("materials", Json::array({"concrete"})));
    // The wall goes on as it is: what was broken stays broken, time does not begin again.
    const Json after = viewer.freshStatus();
    CHECK(after["bonds_broken"] >= before["bonds_broken"]);
    CHECK(after["time"] >= before["time"]);
    const sunder::Image concrete = viewer.keep("31-concrete");
    checkLooksRight(concrete);
    CHECK(sceneDifference(wood, concrete) > 0.2);

    viewer.clickAt("damping", 0.3, 0.5);
    REQUIRE(eventually([&] { return viewer.eventCount("material") >= 2; }));
    CHECK(viewer.freshStatus()["time"] >= after["time"]);

    viewer.type("material_name", "mine");
    viewer.click("save_material");
    REQUIRE(viewer.eventCount("saved_material") == 1);
    std::ifstream saved(screen.folder() / "mine.toml");
    const std::string text(std::istreambuf_iterator<char>(saved), {});
    CHECK(text.find("damping = ") != std::string::npos);
    CHECK(text.find("damping = 1\n") == std::string::npos);

    viewer.click("tab.wall");
    viewer.type("scene_name", "scene");
    viewer.click("save_scene");
    REQUIRE(viewer.eventCount("saved_scene") == 1);
    viewer.keep("32-saved");
    // The program reads both back.
    const auto run = [&](const std::string& scene, const std::string& json) {
        Child child({SUNDER_PROGRAM, "run", scene, "--solver", "cpu", "--frames", "9",
                     "--frames-png", "0", "--out", (screen.folder() / "out").string(), "--json",
                     (screen.folder() / json).string()},
                    {}, screen.folder() / "run.txt");
        child.wait(120);
        std::ifstream said(screen.folder() / "run.txt");
        INFO(std::string(std::istreambuf_iterator<char>(said), {}));
        REQUIRE(child.wait(0) == 0);
        std::ifstream file(screen.folder() / json);
        return Json::parse(file);
    };
    const Json own = run((screen.folder() / "scene.toml").string(), "own.json");
    std::ofstream(screen.folder() / "with.toml")
        << "[[body]]\nname = \"wall\"\nmaterial = \"mine.toml\"\nsize = [3, 2, 0.1]\n"
           "cells = [30, 20, 1]\nanchor = [\"bottom\"]\n[[event]]\ntime = 0.1\nkind = "
           "\"velocity\"\nbody = \"wall\"\npoint = [0.2, 1.1, 0.05]\nradius = 0.3\nvector = [0, 0, "
           "-40]\n";
    const Json with = run((screen.folder() / "with.toml").string(), "with.json");
    CHECK(own["bonds_broken"] > 0);
    CHECK(own["state_hash"] == with["state_hash"]);

    // A new wall of another size.
    const auto seed = viewer.status()["seed"];
    viewer.click("new_seed");
    CHECK(eventually([&] { return viewer.status()["seed"] != seed; }));
    viewer.click("revert_scene");
    CHECK(viewer.becomes("materials", Json::array({"wood"})));
    viewer.quit();
}

TEST_CASE("A picture has the pixels of the window, and those of `sunder run`", "[viewer]") {
    const Screen screen(970, 640);
    ViewerUnderTest viewer(screen, {"glass", "--size", "970x640", "--solver", "cpu"});
    viewer.key("r");
    viewer.key("space");
    viewer.key("r");
    REQUIRE(viewer.becomes("paused", true));
    screen.act("mousemove 5 630");
    viewer.freshStatus();
    const sunder::Image window = viewer.keep("40-glass");
    viewer.key("p");
    REQUIRE(eventually([&] { return viewer.eventCount("picture") == 1; }));
    const sunder::Image picture =
        sunder::readPng(viewer.events("picture")[0]["path"].get<std::string>());
    const Json view = viewer.status()["view"];
    REQUIRE(picture.width == view[2]);
    REQUIRE(picture.height == view[3]);
    CHECK(windowDifference(window, view[0], view[1], picture, picture.height - 60) == 0);

    Child run({SUNDER_PROGRAM, "run", "glass", "--solver", "cpu", "--frames", "1", "--frames-png",
               "1", "--size", std::to_string(picture.width) + "x" + std::to_string(picture.height),
               "--out", (screen.folder() / "out").string()},
              {{"SUNDER_EGL_DEVICE", "software"}}, screen.folder() / "run.txt");
    REQUIRE(run.wait(120) == 0);
    // It draws with four samples.
    viewer.click("samples.4x");
    viewer.key("p");
    REQUIRE(eventually([&] { return viewer.eventCount("picture") == 2; }));
    const sunder::Image sampled =
        sunder::readPng(viewer.events("picture")[1]["path"].get<std::string>());
    const sunder::Image written = sunder::readPng(screen.folder() / "out" / "frame_0000.png");
    CHECK(windowDifference(sampled, 0, 0, written, written.height) == 0);
    viewer.quit();
}

TEST_CASE("Windows that change size, hide or lose the focus do no harm", "[viewer]") {
    const Screen screen(1400, 900);
    ViewerUnderTest viewer(screen, {"brick", "--size", "1000x600", "--solver", "cpu"});
    const std::string find = "search --name '^Sunder$' ";
    for (const auto& [width, height] :
         {std::pair{1300, 800}, {500, 300}, {340, 240}, {1280, 720}}) {
        screen.act(find + "windowsize " + std::to_string(width) + " " + std::to_string(height));
        CHECK(viewer.becomes("window", Json::array({width, height})));
        viewer.clickScene(0.5, 0.5);
    }
    screen.act(find + "windowunmap");
    sleepFor(1);
    screen.act(find + "windowmap");
    viewer.freshStatus();
    // The focus goes while a key is held; its release is never heard of.
    screen.act(find + "windowfocus");
    screen.act("keydown Right");
    viewer.freshStatus();
    screen.act("search --maxdepth 0 '' windowfocus || true");
    screen.act("keyup Right");
    screen.act(find + "windowfocus");
    viewer.key("F11");
    CHECK(viewer.becomes("full_screen", true));
    CHECK(viewer.becomes("window", Json::array({1400, 900})));
    checkLooksRight(viewer.keep("50-full-screen"));
    viewer.key("Escape");
    CHECK(viewer.becomes("full_screen", false));
    screen.act(find + "windowfocus");  // as a window manager does
    viewer.key("Tab");
    CHECK(viewer.status()["view"][0] == 0);
    viewer.key("Tab");
    viewer.quit();
}

TEST_CASE("A minimised window stands still and goes on where it was", "[viewer]") {
    Screen screen(1280, 720);
    screen.manageWindows();
    ViewerUnderTest viewer(screen, {"wood", "--size", "1000x600", "--solver", "cpu"});
    viewer.clickScene(0.5, 0.45);
    CHECK(eventually([&] { return viewer.status()["bonds_broken"] > 20; }));
    const std::string find = "search --name '^Sunder$' ";
    // Asked for again until the window manager is up.
    REQUIRE(eventually([&] {
        screen.act(find + "windowminimize");
        return viewer.freshStatus()["minimised"] == true;
    }));
    const Json hidden = viewer.freshStatus(), later = viewer.freshStatus();
    CHECK(later["time"] == hidden["time"]);
    screen.act(find + "windowmap");
    REQUIRE(viewer.becomes("minimised", false));
    CHECK(viewer.becomes("window", Json::array({1000, 600})));
    const Json shown = viewer.freshStatus();
    // The time it was away for is not made up for.
    CHECK(shown["time"] > hidden["time"]);
    CHECK(shown["time"] < hidden["time"].get<double>() + 60);
    CHECK(shown["bonds_broken"] >= hidden["bonds_broken"]);
    viewer.quit();
}

TEST_CASE("On a screen of small pixels everything is as much larger", "[viewer]") {
    const Screen plain(1280, 720), fine(2560, 1440, 192);
    const auto look = [](const Screen& screen, const std::string& name) {
        ViewerUnderTest viewer(screen, {"brick", "--size", "1280x720", "--solver", "cpu"});
        viewer.click("tab.material");
        viewer.clickScene(0.5, 0.5);
        const Json now = viewer.freshStatus();
        checkLooksRight(viewer.keep(name), now["view"][0]);
        viewer.quit();
        return now;
    };
    const Json small = look(plain, "51-plain-screen");
    const Json large = look(fine, "52-fine-screen");
    CHECK(small["view"][0] == kPanel);
    CHECK(large["view"][0] == 2 * kPanel);
    CHECK(large["window"] == Json::array({2560, 1440}));
    // The same widgets have room, each about twice as large; letters come in whole pixels.
    REQUIRE(small["widgets"].size() == large["widgets"].size());
    for (const auto& [name, place] : small["widgets"].items()) {
        INFO(name);
        for (int side = 0; side < 4; ++side)
            CHECK(std::abs(large["widgets"][name][side].get<double>() -
                           2 * place[side].get<double>()) < 40);
    }
}

TEST_CASE("What was chosen is chosen the next time", "[viewer]") {
    const Screen screen(1000, 600);
    {
        ViewerUnderTest viewer(screen, {"--size", "900x500", "--solver", "cpu"});
        viewer.key("m");
        viewer.key("t");
        viewer.click("solver.scatter");
        viewer.quit();
    }
    {
        ViewerUnderTest viewer(screen, {});
        const Json now = viewer.freshStatus();
        CHECK(now["mesh"] == "simulation");
        CHECK(now["tool"] == "push");
        CHECK(now["solver"] == "scatter");
        CHECK(now["window"] == Json::array({900, 500}));
        viewer.quit();
    }
    // A file that somebody broke is said, and does not keep the viewer from starting.
    std::ofstream(screen.folder() / "home" / "sunder" / "viewer.toml") << "samples = \"many\"\n";
    ViewerUnderTest viewer(screen, {"--solver", "cpu"});
    REQUIRE(viewer.eventCount("problem") == 1);
    CHECK_THAT(viewer.events("problem")[0]["text"].get<std::string>(),
               Catch::Contains("viewer.toml:1") && Catch::Contains("samples"));
    viewer.quit();
}

TEST_CASE(
    "A shader that changes is used at once, a mistake in it is shown, and the old one goes on",
    "[viewer]") {
    const Screen screen(1000, 600);
    const fs::path shaders = screen.folder() / "glsl";
    fs::copy(SUNDER_SHADERS, shaders, fs::copy_options::recursive);
    ViewerUnderTest viewer(
        screen, {"--size", "1000x600", "--solver", "cpu", "--shader-dir", shaders.string()});
    viewer.key("space");
    screen.act("mousemove 990 10");
    const sunder::Image before = viewer.keep("60-shaders");
    const fs::path file = shaders / "draw" / "sky.frag";
    std::ifstream in(file);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    const auto write = [&](const std::string& contents) {
        const std::size_t seen = viewer.eventCount("shaders");
        std::ofstream(file) << contents;
        fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::seconds(seen));
        REQUIRE(eventually([&] { return viewer.eventCount("shaders") > seen; }));
        return viewer.events("shaders").back()["error"];
    };
    const Json error = write(text + "\nbroken\n");
    REQUIRE(error.is_string());
    CHECK_THAT(error.get<std::string>(), Catch::Contains("sky.frag"));
    const sunder::Image during = viewer.keep("61-shader-error");
    // The wall stands as it did, a panel says what is wrong.
    CHECK(difference(before, during, 500, 300, 300, 200) < 0.01);
    CHECK(difference(before, during, 340, 10, 600, 60) > 0.3);

    const std::size_t end = text.rfind('}');
    CHECK(write(text.substr(0, end) + "colour = vec4(1, 0, 0, 1);\n}\n").is_null());
    CHECK(share(viewer.keep("62-red-sky"), 700, 5, 290, 20, 255, 0, 0) > 0.5);
    viewer.quit();
}

TEST_CASE("A video is recorded while it is asked for", "[viewer]") {
    if (std::system("command -v ffmpeg > /dev/null") != 0) return;
    const Screen screen(800, 500);
    ViewerUnderTest viewer(screen, {"--size", "800x500", "--solver", "cpu"});
    viewer.key("v");
    REQUIRE(eventually([&] { return viewer.eventCount("recording") == 1; }));
    const Json first = viewer.freshStatus();
    for (int i = 0; i < 4; ++i) viewer.freshStatus();
    viewer.key("v");
    REQUIRE(eventually([&] { return viewer.eventCount("video") == 1; }));
    const Json video = viewer.events("video")[0];
    CHECK(video["frames"] > 5);
    CHECK(fs::file_size(video["path"].get<std::string>()) > 1000);
    viewer.quit();
}

TEST_CASE("Every scene can be opened from the list", "[viewer]") {
    const Screen screen(1280, 720);
    ViewerUnderTest viewer(screen, {"wood", "--size", "1280x720", "--solver", "cpu"});
    viewer.click("tab.wall");
    for (const std::string& name : sceneNames()) {
        INFO(name);
        viewer.click("scene");
        viewer.click("scene." + name);
        REQUIRE(viewer.becomes("scene", name));
        checkLooksRight(viewer.keep("70-scene-" + name));
        CHECK(viewer.status()["nan"] == 0);
    }
    viewer.quit();
}

TEST_CASE("A minute of clicks and keys at random", "[viewer]") {
    const Screen screen(1100, 700);
    ViewerUnderTest viewer(screen, {"wood", "--size", "1100x700", "--solver", "cpu"});
    std::mt19937 random(20240607);
    const std::vector<std::string> keys{
        "space", "period", "comma", "bracketleft", "bracketright", "r", "n", "t", "m", "l",
        "c",     "p",      "h",     "Home",        "Tab",          "1", "5", "9", "g", "Escape",
        "F11",   "a",      "w",     "Return"};
    const auto start = std::chrono::steady_clock::now();
    int actions = 0;
    while (std::chrono::steady_clock::now() - start < std::chrono::seconds(60)) {
        const int x = static_cast<int>(random() % 1100), y = static_cast<int>(random() % 700);
        const std::string at = "mousemove " + std::to_string(x) + " " + std::to_string(y);
        switch (random() % 4) {
            case 0:
                screen.act("key " + keys[random() % keys.size()]);
                break;
            case 1:
                screen.act(at + " mousedown 1 mousemove_relative -- " +
                           std::to_string(static_cast<int>(random() % 200) - 100) +
                           " 30 mouseup 1");
                break;
            default:
                screen.act(at + " click " + std::to_string(random() % 5 + 1));
        }
        ++actions;
        INFO("action " << actions << "\n" << viewer.output());
        REQUIRE(viewer.running());
        sleepFor(0.05);
    }
    CHECK(actions > 50);
    viewer.keep("80-random");
    CHECK(viewer.status()["nan"] == 0);
    viewer.quit();
}

TEST_CASE("Without a screen it says so, and what to do", "[viewer]") {
    const fs::path output = fs::temp_directory_path() / "sunder-no-screen.txt";
    Child child({SUNDER_PROGRAM, "view"}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}, output);
    CHECK(child.wait(60) == 3);
    std::ifstream file(output);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    fs::remove(output);
    CHECK(text.starts_with("sunder: "));
    CHECK(text.find("sunder run") != std::string::npos);
    CHECK(std::count(text.begin(), text.end(), '\n') == 1);
}

TEST_CASE("Wrong use is a sentence before any window opens", "[viewer]") {
    const fs::path output = fs::temp_directory_path() / "sunder-wrong-view.txt";
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"woood"},
                                               {"--solver", "fast"},
                                               {"--size", "big"},
                                               {"--log", "/no/such/folder/log"},
                                               {"--out", "/no/such/folder"}}) {
        std::vector<std::string> command{SUNDER_PROGRAM, "view"};
        command.insert(command.end(), arguments.begin(), arguments.end());
        Child child(command, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}, output);
        INFO(arguments.back());
        CHECK(child.wait(60) == 2);
        std::ifstream file(output);
        const std::string text(std::istreambuf_iterator<char>(file), {});
        CHECK(text.find(arguments.back()) != std::string::npos);
        CHECK(std::count(text.begin(), text.end(), '\n') == 1);
    }
    fs::remove(output);
}
