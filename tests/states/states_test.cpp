// What solvers compute, against what they computed when tests/states was last renewed: to the bit,
// on the drivers it has records of.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "files/utf8_path.hpp"
#include "files/write_file.hpp"
#include "scene/scene.hpp"
#include "states/record.hpp"
#include "states/update.hpp"
#include "support/solver_under_test.hpp"

using namespace sunder;
using namespace sunder::core;
namespace fs = std::filesystem;

namespace {

/// Where stored states lie: of this checkout, unless the program runs on another machine.
fs::path folder() {
    const char* elsewhere = std::getenv("SUNDER_STATES");
    return elsewhere ? elsewhere : SUNDER_STATES;
}
const fs::path kReport = fs::path(SUNDER_REPORT) / "states";

struct StoredScene {
    std::string name;
    int frames;  ///< until pieces fly
};
/// Each kind of fracture and of material law; objects; a chain; walls that fall on one another;
/// `touching` also a room, early.
const StoredScene kScenes[] = {
    {"wood", 12},     {"concrete", 12}, {"glass", 12},  {"rubber", 8},         {"wood-thesis", 12},
    {"touching", 20}, {"brick", 10},    {"planks", 12}, {"wrecking-ball", 10}, {"heap", 24}};

scene::Scene load(const std::string& name) {
    scene::Scene scene = scene::loadScene(
        name == "touching" ? files::utf8FromPath(folder() / "touching.toml") : name);
    if (name == "wrecking-ball") {
        // A second of swinging is left out: the ball begins a twentieth of a second before the
        // wall, on its circle of 4 m and as fast as the fall has made it.
        ObjectDescription& ball = scene.world.objects.at(0);
        const double before = 0.1;  // rad
        const Vec3 rope = *ball.position - *ball.hungFrom;
        const double length = rope.norm(), fallen = length * std::cos(before) + rope[1];
        const double speed = std::sqrt(2 * 9.81 * fallen);
        ball.position = *ball.hungFrom + length * Vec3(0, -std::cos(before), std::sin(before));
        ball.velocity = speed * Vec3(0, -std::sin(before), -std::cos(before));
    }
    return scene;
}

std::vector<SolverUnderTest> storedSolvers() {
    std::vector<SolverUnderTest> result = solversUnderTest();
    std::erase_if(result, [](const SolverUnderTest& under) {
        // compute has gather's passes, and is compared with it (tests/gpu/compute_test.cpp).
        return under.name == "reference" || under.name == "auto" || under.name == "compute";
    });
    return result;
}

/// The driver's name as that of a folder.
fs::path driverFolder() {
    std::string name = driverUnderTest();
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.') c = '-';
    name.erase(
        std::unique(name.begin(), name.end(), [](char a, char b) { return a == '-' && b == '-'; }),
        name.end());
    return folder() / name;
}

fs::path fileOf(const std::string& scene, const std::string& solver) {
    return driverFolder() / solver / (scene + ".txt");
}

std::string toAccept(const std::string& scene) {
    return "tools/update-states " + scene;
}

void report(const std::string& scene, const std::string& solver, const std::string& verdict,
            const std::string& sentence) {
    fs::create_directories(kReport);
    files::writeFile(kReport / (solver + "-" + scene + ".json"),
                     nlohmann::json{{"scene", scene},
                                    {"solver", solver},
                                    {"driver", driverUnderTest()},
                                    {"verdict", verdict},
                                    {"sentence", sentence},
                                    {"accept", toAccept(scene)}}
                         .dump(2));
}

/// Reports it, and returns what is wrong with it.
std::string compareWithStored(const StoredScene& stored, const SolverUnderTest& under) {
    const auto say = [&](const char* verdict, const std::string& sentence) {
        report(stored.name, under.name, verdict, sentence);
        return sentence;
    };
    const scene::Scene scene = load(stored.name);
    const std::int64_t steps = std::int64_t{stored.frames} * scene.substeps;
    Record before;
    try {
        before = readRecord(fileOf(stored.name, under.name));
    } catch (const InputError& error) {
        return say("no stored state", error.what());
    }
    if (before.empty() || before.back().step != steps)
        return say("no stored state", files::utf8FromPath(fileOf(stored.name, under.name)) +
                                          ": must reach to step " + std::to_string(steps));
    const World world(scene.world);
    const std::unique_ptr<Solver> solver = under.make(world);
    const std::string difference = firstDifference(before, record(*solver, before), scene.substeps);
    return say(difference.empty() ? "same" : "different", difference);
}

}  // namespace

TEST_CASE("states are the stored ones", "[states][stored]") {
    if (!fs::exists(driverFolder())) {
        for (const SolverUnderTest& under : storedSolvers())
            for (const StoredScene& scene : kScenes)
                report(scene.name, under.name, "no stored state", "none of this driver's");
        // With these words ctest counts the test as skipped (tests/CMakeLists.txt).
        WARN("no stored states of this driver: " << driverUnderTest());
        return;
    }
    for (const SolverUnderTest& under : storedSolvers())
        for (const StoredScene& scene : kScenes) {
            const std::string wrong = compareWithStored(scene, under);
            if (!wrong.empty())
                FAIL_CHECK(scene.name
                           << ", " << under.name << ": " << wrong
                           << ". If what is computed now is right: " << toAccept(scene.name));
        }
}

void updateStates(const std::vector<std::string>& arguments) {
    if (std::getenv("CI")) throw InputError("states are never renewed by a CI machine");
    if (arguments.size() > 1) throw InputError("at most one scene");
    bool any = false;
    for (const SolverUnderTest& under : storedSolvers())
        for (const auto& [name, frames] : kScenes) {
            if (!arguments.empty() && name != arguments[0]) continue;
            any = true;
            const scene::Scene scene = load(name);
            const World world(scene.world);
            const std::unique_ptr<Solver> solver = under.make(world);
            const fs::path file = fileOf(name, under.name);
            fs::create_directories(file.parent_path());
            files::writeFile(file, "# Scene " + name + ", solver " + under.name + ", on " +
                                       driverUnderTest() + ". Made by tools/update-states.\n" +
                                       toText(record(*solver, everyStep(frames * scene.substeps))));
            std::cout << "wrote " << files::utf8FromPath(file) << '\n';
        }
    if (!any) throw InputError("no states are stored of a scene '" + arguments[0] + "'");
}
