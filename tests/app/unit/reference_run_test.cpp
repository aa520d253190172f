// Good runs of `sunder run` that need no OpenGL: what --json and --state hold.
#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "app/support/flying_objects.hpp"
#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "app/support/vtu_file.hpp"
#include "catch.hpp"

using nlohmann::json;

namespace {

Result runReference(const Workplace& place, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"run",          "wall.toml", "--solver", "reference",
                                       "--frames-png", "0",         "--json",   "wall.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Result result = place.run(arguments, kNoGl);
    INFO(result.command << "\nstderr: " << result.err);
    REQUIRE(result.exitCode == 0);
    return result;
}

std::string hashOf(const Workplace& place, const std::string& seed) {
    runReference(place, {"--seed", seed});
    return place.readJson("wall.json").at("state_hash");
}

/// The nth vector of an array of three components.
Eigen::Vector3d vectorAt(const VtuArray& array, std::size_t n) {
    return Eigen::Vector3d::Map(&array.values[3 * n]);
}

}  // namespace

TEST_CASE("App: the report holds what it promises, and free fall has the numbers of free fall") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    const Result result = runReference(place);
    CHECK(result.err.empty());
    CHECK(place.contents() == std::set<std::string>{"out", "out/wall", "out/wall/report.json",
                                                    "wall.json", "wall.toml"});
    CHECK(place.read("out/wall/report.json") == place.read("wall.json"));

    const json report = place.readJson("wall.json");
    CHECK(report.at("scene") == "wall");
    CHECK(report.at("solver") == "reference");
    CHECK(report.at("gl_renderer") == "");
    CHECK(report.at("frames") == 5);
    CHECK(report.at("steps_per_frame") == 50);
    CHECK(report.at("dt").get<double>() == Approx(1. / 3000));
    CHECK(report.at("cells") == scenes::kCells);
    CHECK(report.at("tetrahedra") == 5 * scenes::kCells);
    CHECK(report.at("nodes") == 8 * scenes::kCells);
    CHECK(report.at("bonds_total") == scenes::kBonds);
    CHECK(report.at("bonds_broken") == 0);
    CHECK(report.at("pieces") == 1);
    CHECK(report.at("nan") == 0);
    CHECK(report.at("stiffness_limited").empty());
    const std::string hash = report.at("state_hash");
    CHECK(hash.size() == 16);
    CHECK(hash.find_first_not_of("0123456789abcdef") == std::string::npos);

    // 0.6 × 0.4 × 0.1 m of 1000 kg/m³, 250 steps of symplectic Euler: the nth lowers it by n·g·h².
    const double mass = 24, g = 9.81, h = 1. / 3000, time = 5. / 60;
    const double drop = g * h * h * 250 * 251 / 2;
    CHECK(report.at("min_y").get<double>() == Approx(1 - drop).margin(1e-5));
    CHECK(report.at("max_speed").get<double>() == Approx(g * time).epsilon(1e-4));
    CHECK(report.at("momentum").size() == 3);
    CHECK(report.at("momentum")[0].get<double>() == Approx(0).margin(1e-3));
    CHECK(report.at("momentum")[1].get<double>() == Approx(-mass * g * time).epsilon(1e-4));
    CHECK(report.at("momentum")[2].get<double>() == Approx(0).margin(1e-3));
    const json& energy = report.at("energy");
    CHECK(energy.size() == 3);
    CHECK(energy.at("kinetic").get<double>() ==
          Approx(mass * g * g * time * time / 2).epsilon(1e-4));
    CHECK(energy.at("gravity").get<double>() == Approx(mass * g * (1.2 - drop)).epsilon(1e-4));
    CHECK(energy.at("elastic").get<double>() == Approx(0).margin(1e-3));
    const json& spent = report.at("ms_per_step");
    CHECK(spent.at("median").get<double>() > 0);
    CHECK(spent.at("p95").get<double>() >= spent.at("median").get<double>());
}

TEST_CASE("App: --frames and --fps set how many steps there are") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    runReference(place, {"--frames", "3", "--fps", "100"});
    const json report = place.readJson("wall.json");
    CHECK(report.at("frames") == 3);
    CHECK(report.at("steps_per_frame") == 30);
    CHECK(report.at("dt").get<double>() == Approx(1. / 3000));
    CHECK(report.at("max_speed").get<double>() == Approx(9.81 * 0.03).epsilon(1e-4));
}

TEST_CASE("App: a seed gives the same wall twice, another seed another wall") {
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    const std::string once = hashOf(place, "7");
    CHECK(place.readJson("wall.json").at("seed") == 7);
    CHECK(place.readJson("wall.json").at("bonds_broken") > 0);
    CHECK(place.readJson("wall.json").at("pieces") > 1);
    CHECK(place.readJson("wall.json").at("nan") == 0);
    CHECK(hashOf(place, "7") == once);
    CHECK(hashOf(place, "8") != once);
    CHECK(hashOf(place, "18446744073709551615") != once);
}

TEST_CASE("App: the report counts breaks and contacts, and has the strongest ten of them") {
    const Workplace place;
    std::string scene = scenes::kBreaking;
    scene.replace(scene.find("strength = 1e6"), 14, "strength = 1e5");  // weaker than the blow
    scene +=
        "[contact]\nenabled = true\n[[object]]\nname = 'ball'\nshape = 'sphere'\nradius = 0.05\n"
        "mass = 5\nposition = [0, 0.2, 0.2]\nvelocity = [0, 0, -20]\n";
    place.write("wall.toml", scene);
    const Result result = runReference(place);
    const json report = place.readJson("wall.json"), &incidents = report.at("incidents");
    CHECK(incidents.at("breaks") == report.at("bonds_broken"));
    CHECK(incidents.at("contacts") > 0);
    CHECK(incidents.at("dropped") == 0);
    CHECK(incidents.at("capacity") > 1000);
    CHECK(result.out.find("incidents: ") != std::string::npos);
    const json& strongest = incidents.at("strongest");
    REQUIRE(strongest.size() == 10);
    double before = strongest[0].at("impulse");
    bool byBall = false;
    for (const json& incident : strongest) {
        CHECK(incident.at("impulse") <= before);
        CHECK(incident.at("impulse") > 0);
        before = incident.at("impulse");
        CHECK(incident.at("time") > 0);
        CHECK(incident.at("place").size() == 3);
        CHECK(incident.at("piece") >= 0);
        CHECK(incident.at("piece") < report.at("pieces"));
        CHECK(incident.at("materials")[0] == "soft");
        const bool contact = incident.at("kind") == "contact";
        CHECK((contact || incident.at("kind") == "break"));
        if (!incident.at("object").is_null()) {
            byBall = true;
            CHECK(contact);
            CHECK(incident.at("object") == "ball");
        }
    }
    CHECK(byBall);
}

TEST_CASE("App: the report has every object's state as free flight has it") {
    const Workplace place;
    place.write("wall.toml", flying::scene());
    for (const std::string solver : {"reference", "cpu"}) {
        INFO(solver);
        const Result result = place.run(
            {"run", "wall.toml", "--solver", solver, "--frames-png", "0", "--json", "wall.json"},
            kNoGl);
        REQUIRE(result.exitCode == 0);
        flying::check(place.readJson("wall.json"));
        CHECK(place.readJson("wall.json").at("lost").at("contacts") == 0);
    }
}

TEST_CASE("App: a stiffness that the step does not carry is told on stderr and in the report") {
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    const Result result = runReference(place);
    CHECK(contains(result.err, "soft: E 1e+10 limited to "));
    CHECK(contains(result.err, " Pa at 50 substeps"));
    const json limits = place.readJson("wall.json").at("stiffness_limited");
    REQUIRE(limits.size() == 1);
    CHECK(limits[0].at("material") == "soft");
    CHECK(limits[0].at("young_modulus") == 1e10);
    const double limit = limits[0].at("limited_to");
    CHECK(limit > 0);
    CHECK(limit < 1e10);
    // What follows: sag goes with 1/E.
    CHECK(limits[0].at("sags_times_as_far").get<double>() == Approx(1e10 / limit));
    CHECK(contains(result.err, " substeps per 1/60 s: it sags "));
    CHECK(contains(result.err, " times as far"));

    // Twice as many steps carry four times as much.
    place.write("wall.toml", scenes::kBreaking + "[solver]\nsubsteps = 100\n");
    CHECK(contains(runReference(place).err, " Pa at 100 substeps"));
    const json finer = place.readJson("wall.json").at("stiffness_limited");
    REQUIRE(finer.size() == 1);
    CHECK(finer[0].at("limited_to").get<double>() == Approx(4 * limit));
}

TEST_CASE("App: what could not be carried is told on stderr and in the report") {
    const Workplace place;
    // A box of 1,000 kg on nine cells of 0.1 kg, which alone push it up.
    place.write("wall.toml", R"([material.foam]
density = 100
young_modulus = 1e10
fracture = "none"
[[body]]
name = "cushion"
material = "foam"
size = [0.3, 0.3, 0.3]
cells = [3, 3, 3]
[[object]]
name = "safe"
shape = "box"
size = [0.3, 0.3, 0.3]
mass = 1000
position = [0, 0.45, 0]
)");
    const Result result = place.run({"run", "wall.toml", "--solver", "cpu", "--frames", "60",
                                     "--frames-png", "0", "--json", "wall.json"},
                                    kNoGl);
    REQUIRE(result.exitCode == 0);
    CHECK(contains(result.err, "'cushion' and 'safe' are in each other by "));
    const json sunk = place.readJson("wall.json").at("lost").at("sunk");
    REQUIRE(sunk.size() == 1);
    CHECK(sunk[0].at("a") == "cushion");
    CHECK(sunk[0].at("b") == "safe");
    CHECK(sunk[0].at("depth") > 0.0);
    CHECK(place.readJson("wall.json").at("lost").at("outrun").empty());
}

TEST_CASE("App: --state is a .vtu with every point, cell and array it promises") {
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    runReference(place, {"--state", "wall.vtu"});
    const json report = place.readJson("wall.json");
    const VtuFile file = parseVtu(place.read("wall.vtu"));
    CHECK(file.points == 8 * scenes::kCells);
    CHECK(file.cells == 5 * scenes::kCells);

    struct Wanted {
        std::string name, section, type;
        int components, count;
    };
    for (const Wanted& wanted :
         {Wanted{"Points", "Points", "Float32", 3, file.points},
          Wanted{"displacement", "PointData", "Float32", 3, file.points},
          Wanted{"velocity", "PointData", "Float32", 3, file.points},
          Wanted{"material", "CellData", "Int32", 1, file.cells},
          Wanted{"piece", "CellData", "Int32", 1, file.cells},
          Wanted{"max_principal_stress", "CellData", "Float32", 1, file.cells},
          Wanted{"offsets", "Cells", "Int64", 1, file.cells},
          Wanted{"types", "Cells", "UInt8", 1, file.cells},
          Wanted{"connectivity", "Cells", "Int64", 1, 4 * file.cells}}) {
        INFO(wanted.name);
        REQUIRE(file.arrays.count(wanted.name) == 1);
        const VtuArray& array = file.arrays.at(wanted.name);
        CHECK(array.section == wanted.section);
        CHECK(array.type == wanted.type);
        CHECK(array.components == wanted.components);
        CHECK(array.values.size() ==
              static_cast<std::size_t>(wanted.components) * static_cast<std::size_t>(wanted.count));
    }
    CHECK(file.arrays.size() == 9);

    const auto all = [&](const char* name, const std::function<bool(double)>& holds) {
        INFO(name);
        for (const double value : file.arrays.at(name).values)
            if (!holds(value)) FAIL_CHECK("value " << value);
    };
    const auto below = [](int count) {
        return [count](double value) { return value >= 0 && value < count; };
    };
    all("connectivity", below(file.points));
    all("piece", below(report.at("pieces")));
    all("material", [](double value) { return value == 0; });
    all("types", [](double value) { return value == 10; });  // VTK_TETRA
    for (const char* name : {"Points", "velocity", "max_principal_stress"})
        all(name, [](double value) { return std::isfinite(value); });

    const std::vector<double>& offsets = file.arrays.at("offsets").values;
    for (std::size_t i = 0; i < offsets.size(); ++i)
        if (offsets[i] != 4. * static_cast<double>(i + 1)) FAIL_CHECK("offset " << i);

    // Where the wall stood: every tetrahedron there is a sixth or a third of a cell of 1e-3 m³, and
    // all of them fill the body.
    const VtuArray &points = file.arrays.at("Points"), &moved = file.arrays.at("displacement");
    const std::vector<double>& connectivity = file.arrays.at("connectivity").values;
    double volume = 0, farthest = 0;
    for (std::size_t i = 0; i < connectivity.size(); i += 4) {
        Eigen::Vector3d rest[4];
        for (std::size_t k = 0; k < 4; ++k) {
            const auto n = static_cast<std::size_t>(connectivity[i + k]);
            rest[k] = vectorAt(points, n) - vectorAt(moved, n);
            farthest = std::max(farthest, std::abs(rest[k].x()));
        }
        const double v = (rest[1] - rest[0]).cross(rest[2] - rest[0]).dot(rest[3] - rest[0]) / 6;
        if (std::abs(v - 1e-3 / 6) > 1e-6 && std::abs(v - 1e-3 / 3) > 1e-6)
            FAIL_CHECK("tetrahedron " << i / 4 << " of " << v << " m³");
        volume += v;
    }
    CHECK(volume == Approx(0.6 * 0.4 * 0.1).epsilon(1e-4));
    CHECK(farthest == Approx(0.3).margin(1e-5));

    double lowest = 1;
    for (std::size_t n = 0; n < points.values.size() / 3; ++n)
        lowest = std::min(lowest, vectorAt(points, n).y());
    CHECK(lowest == Approx(report.at("min_y").get<double>()).margin(1e-6));
}

TEST_CASE("App: --json and --state may lie in the folder that --out makes") {
    const Workplace place;
    place.write("wall.toml", scenes::kFalling);
    runReference(place, {"--out", "a/b", "--state", "./a/b/wall.vtu"});
    CHECK(place.contents() == std::set<std::string>{"a", "a/b", "a/b/report.json", "a/b/wall.vtu",
                                                    "wall.json", "wall.toml"});
}

TEST_CASE("App: a file that is not well-formed XML does not pass for a .vtu") {
    const std::string head = "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>";
    const std::string piece = "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"/>";
    CHECK_NOTHROW(parseVtu(head + piece + "</UnstructuredGrid></VTKFile>"));
    for (const std::string& bad :
         {std::string(), head, head + piece + "</VTKFile></UnstructuredGrid>",
          head + "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"" +
              "</UnstructuredGrid></VTKFile>",
          head + piece + "</UnstructuredGrid></VTKFile>x",
          std::string("<VTKFile type=\"PolyData\"/>")})
        CHECK_THROWS(parseVtu(bad));
}
