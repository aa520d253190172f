// tools/update-baselines: what it renews, and when it refuses.
#include "image/renewal.hpp"

#include <algorithm>

#include "catch.hpp"
#include "files/utf8_path.hpp"
#include "files/write_file.hpp"
#include "image/device.hpp"
#include "image/stored_state.hpp"
#include "support/test_folder.hpp"

using namespace sunder;
using namespace sunder::core;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

const gl::DeviceInfo kMaker = device("llvmpipe (LLVM 15.0.6, 256 bits)", "4.5 Mesa 22.3.6");

/// Two pictures of one state, one of another, and one of a GPU solver with the first's baseline.
Suite smallSuite() {
    Suite suite;
    suite.baselineRenderer = "llvmpipe (LLVM 15.";
    suite.baselineVersion = "Mesa 22.3.";
    const auto add = [&](const char* name, int frame, SuiteSolver solver, const char* baseline) {
        SuitePicture picture;
        picture.name = name;
        picture.scene = "wood-thesis";
        picture.frame = frame;
        picture.solver = solver;
        picture.baseline = baseline;
        picture.settings.width = 64;
        picture.settings.height = 48;
        suite.pictures.push_back(picture);
    };
    add("a", 2, SuiteSolver::Cpu, "a");
    add("b", 2, SuiteSolver::Cpu, "b");
    add("c", 1, SuiteSolver::Cpu, "c");
    add("gathered", 2, SuiteSolver::Gather, "a");
    return suite;
}

using Names = std::vector<std::string>;

Names renewIn(const TestFolder& folder, const Renewal& renewal,
              const gl::DeviceInfo& info = kMaker) {
    Names names;
    for (const fs::path& path : renew(smallSuite(), folder.path(), info, renewal))
        names.push_back(files::utf8FromPath(path.filename()));
    std::sort(names.begin(), names.end());
    return names;
}

void checkRefused(const Renewal& renewal, const gl::DeviceInfo& info, const std::string& why) {
    const TestFolder folder;
    CHECK_THROWS_WITH(renewIn(folder, renewal, info), Contains(why));
    CHECK(fs::is_empty(folder.path()));
}

}  // namespace

TEST_CASE("baselines are not renewed by a CI machine, nor by another driver") {
    checkRefused({.ci = true}, kMaker, "CI");
    checkRefused({.states = true, .ci = true}, kMaker, "CI");
    checkRefused({}, device("NVIDIA H200/PCIe/SSE2", "4.1.0 NVIDIA 580.159.04"), "NVIDIA");
    checkRefused({}, device("llvmpipe (LLVM 17.0.6, 256 bits)", "4.5 Mesa 22.3.6"), "LLVM 17");
    checkRefused({}, device(kMaker.renderer, "4.5 Mesa 24.0.1"), "Mesa 24.0.1");
    checkRefused({.only = "no-such"}, kMaker, "no picture 'no-such'");
    checkRefused({.only = "gathered"}, kMaker, "'a'");
    CHECK(renewalRefused(smallSuite(), kMaker, false).empty());
}

TEST_CASE("states are stored where there are none, and renewed only when asked for") {
    const TestFolder folder;
    CHECK(renewIn(folder, {.only = "a"}) == Names{"a.png", "wood-thesis-2.state"});
    CHECK(renewIn(folder, {}) == Names{"a.png", "b.png", "c.png", "wood-thesis-1.state"});

    // As if the physics had moved: what is stored is kept.
    const fs::path state = folder.path() / "states" / "wood-thesis-2.state";
    const World world(scene::loadScene("wood-thesis").world);
    const State simulated = readState(state, world);
    State other = simulated;
    for (Vec3& displacement : other.displacement) displacement[1] = 1;
    writeState(state, other);
    CHECK(renewIn(folder, {.only = "a"}) == Names{"a.png"});
    CHECK((readState(state, world).displacement == other.displacement));

    CHECK(renewIn(folder, {.only = "a", .states = true}) ==
          Names{"a.png", "b.png", "wood-thesis-2.state"});
    CHECK((readState(state, world).displacement == simulated.displacement));
}
