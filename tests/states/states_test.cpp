// What solvers compute, against what they computed when tests/states was last renewed: to the bit,
// on the drivers it has records of.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "files/write_file.hpp"
#include "scene/scene.hpp"
#include "states/record.hpp"
#include "support/solver_under_test.hpp"

using namespace sunder;
namespace fs = std::filesystem;

namespace {

const fs::path kFolder = SUNDER_STATES;
const fs::path kReport = fs::path(SUNDER_REPORT) / "states";

struct StoredScene {
    std::string name;
    int frames;  ///< until pieces fly
};
/// Each kind of fracture and of material law; objects; `touching` also a room, early.
const StoredScene kScenes[] = {{"wood", 12},  {"concrete", 12},    {"glass", 12},
                               {"rubber", 8}, {"wood-thesis", 12}, {"touching", 20}};

Scene load(const std::string& name) {
    return loadScene(name == "touching" ? (kFolder / "touching.toml").string() : name);
}

std::vector<SolverUnderTest> storedSolvers() {
    std::vector<SolverUnderTest> result = solversUnderTest();
    std::erase_if(result, [](const SolverUnderTest& under) {
        return under.name == "reference" || under.name == "auto";
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
    return kFolder / name;
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
    writeFile(kReport / (solver + "-" + scene + ".json"),
              nlohmann::json{{"scene", scene},
                             {"solver", solver},
                             {"driver", driverUnderTest()},
                             {"verdict", verdict},
                             {"sentence", sentence},
                             {"accept", toAccept(scene)}}
                  .dump(2));
}

/// Reports it, and returns what is wrong with it.
std::string compareWithStored(const std::string& name, const SolverUnderTest& under) {
    const Scene scene = load(name);
    const World world(scene.world);
    const Record stored = readRecord(fileOf(name, under.name));
    const std::unique_ptr<Solver> solver = under.make(world);
    const std::string difference = firstDifference(stored, record(*solver, stored), scene.substeps);
    report(name, under.name, difference.empty() ? "same" : "different", difference);
    return difference;
}

}  // namespace

TEST_CASE("states are the stored ones", "[states]") {
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
            const std::string difference = compareWithStored(scene.name, under);
            if (!difference.empty())
                FAIL_CHECK(scene.name << ", " << under.name << ": " << difference
                                      << ". If it is right: " << toAccept(scene.name));
        }
}

// tools/update-states runs this, and nothing else does.
TEST_CASE("renew states", "[.update]") {
    if (std::getenv("CI")) FAIL("states are never renewed by a CI machine");
    const char* only = std::getenv("SUNDER_STATE");
    bool any = false;
    for (const SolverUnderTest& under : storedSolvers())
        for (const auto& [name, frames] : kScenes) {
            if (only && name != only) continue;
            any = true;
            const Scene scene = load(name);
            const World world(scene.world);
            const std::unique_ptr<Solver> watched = under.make(world);
            const Record plan = planRecord(world, *watched, frames, scene.substeps);
            const std::unique_ptr<Solver> solver = under.make(world);
            const fs::path file = fileOf(name, under.name);
            fs::create_directories(file.parent_path());
            writeFile(file, "# Scene " + name + ", solver " + under.name + ", on " +
                                driverUnderTest() + ". Made by tools/update-states.\n" +
                                toText(record(*solver, plan)));
            WARN("wrote " << file.string());
        }
    if (!any) FAIL("no states are stored of a scene '" << only << "'");
}
