// tests/image/suite.toml as a language: what it may say, and what is refused.
#include "catch.hpp"
#include "image/device.hpp"
#include "image/suite.hpp"

using namespace sunder;
using namespace sunder::core;
using Catch::Contains;

namespace {

const std::string kDrivers = R"([baseline_driver]
renderer = "llvmpipe (LLVM 15."
version = "Mesa 22.3."
threshold = 8
share = 0.002
window = 0.15
mean = 0.5
[other_drivers]
threshold = 16
share = 0.005
window = 0.2
mean = 3
)";

Suite parse(const std::string& pictures) {
    return parseSuite(kDrivers + pictures, "suite.toml");
}

std::string refusal(const std::string& text) {
    try {
        parseSuite(text, "suite.toml");
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

std::string refusalOf(const std::string& pictures) {
    return refusal(kDrivers + pictures);
}

const gl::DeviceInfo kBookworm =
    device("llvmpipe (LLVM 15.0.6, 256 bits)", "4.5 (Core Profile) Mesa 22.3.6");

const std::string kWood = "[[picture]]\nname = \"a\"\nscene = \"wood\"\nframe = 3\n";

}  // namespace

TEST_CASE("the baseline driver is one renderer of one version of Mesa") {
    const Suite suite = parse(kWood);
    CHECK(suite.madeBaselines(kBookworm));
    CHECK_FALSE(suite.madeBaselines(device(kBookworm.renderer, "4.5 (Core Profile) Mesa 23.1.0")));
    CHECK_FALSE(suite.madeBaselines(
        device("llvmpipe (LLVM 16.0.6, 256 bits)", "4.5 (Core Profile) Mesa 22.3.6")));
    CHECK_FALSE(suite.madeBaselines(device("NVIDIA H200/PCIe/SSE2", "4.1.0 NVIDIA 580.159.04")));
}

TEST_CASE("a picture may have a solver, another's baseline, and a camera and limits of its own") {
    const Suite suite = parse(kWood +
                              "[[picture]]\nname = \"b\"\nscene = \"wood\"\nframe = 3\n"
                              "solver = \"scatter\"\nbaseline = \"a\"\nthreshold = 12\n"
                              "share = 0.001\nmean = 4\nmesh = \"simulation\"\n");
    const SuitePicture &a = suite.picture("a"), &b = suite.picture("b");
    CHECK(a.solver == SuiteSolver::Cpu);
    CHECK(a.storedState());
    CHECK(a.ownBaseline());
    CHECK(b.solver == SuiteSolver::Scatter);
    CHECK_FALSE(b.storedState());
    CHECK(baselineOf("x", b) == baselineOf("x", a));
    CHECK(b.settings.mesh == render::DrawnMesh::Simulation);
    CHECK_THROWS_AS(suite.picture("c"), InputError);

    CHECK_FALSE(a.camera);
    const Suite near = parse(kWood + "camera = [1, 2.5, 3]\ntarget = [0, -1, 0.5]\n");
    CHECK(near.picture("a").camera == Vec3(1, 2.5, 3));
    CHECK(near.picture("a").target == Vec3(0, -1, 0.5));

    CHECK(suite.limits(a, kBookworm).share == 0.002);
    const image::ComparisonLimits own = suite.limits(b, kBookworm);
    CHECK(own.threshold == 12);
    CHECK(own.share == 0.001);
    CHECK(own.window == 0.15);
    CHECK(own.mean == 4);
    // A driver that needs wide bounds needs them for this picture too.
    const image::ComparisonLimits wider = suite.limits(b, device("NVIDIA", "4.1.0"));
    CHECK(wider.threshold == 16);
    CHECK(wider.share == 0.005);
    CHECK(wider.window == 0.2);
    CHECK(wider.mean == 4);
}

TEST_CASE("a mistake in the suite is refused with its line") {
    REQUIRE(refusalOf(kWood) == "none");
    CHECK_THAT(refusalOf(kWood + "tolerance = 1\n"),
               Contains("suite.toml:17") && Contains("tolerance"));
    CHECK_THAT(refusalOf(kWood + "solver = \"reference\"\n"),
               Contains("solver") && Contains("gather"));
    CHECK_THAT(refusalOf(kWood + "colour = 3\n"), Contains("colour"));
    CHECK_THAT(refusalOf(kWood + "camera = [1, 2]\n"), Contains("camera"));
    CHECK_THAT(refusalOf(kWood + "share = 1.5\n"), Contains("share"));
    CHECK_THAT(refusalOf(kWood + "window = -0.1\n"), Contains("window"));
    CHECK_THAT(refusalOf(kWood + "mean = nan\n"), Contains("mean"));
    CHECK_THAT(refusalOf(kWood + "threshold = 0.5\n"), Contains("threshold"));
    CHECK_THAT(refusalOf(kWood + "baseline = \"b\"\n"), Contains("no picture above"));
    CHECK_THAT(refusalOf(kWood + kWood), Contains("another picture has this name"));
    CHECK_THAT(refusalOf("[[picture]]\nname = \"../a\"\nscene = \"wood\"\nframe = 3\n"),
               Contains("name must be of"));
    CHECK_THAT(refusalOf("[[picture]]\nname = \"a\"\nscene = \"wood\"\n"), Contains("frame"));
    CHECK_THAT(refusalOf("[[picture]]\nname = \"a\"\nscene = \"wood\"\nframe = -1\n"),
               Contains("frame"));
    CHECK_THAT(refusal(kWood), Contains("baseline_driver"));
    CHECK_THAT(refusal(kDrivers.substr(0, kDrivers.find("[other_drivers]"))),
               Contains("other_drivers"));
}
