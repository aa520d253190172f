// `sunder bench` with OpenGL: GPU solvers, pictures, passes and the plot. What it measures is never
// compared with a time.
#include <map>

#include "app/support/bench_report.hpp"
#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "app/support/xml_reader.hpp"
#include "catch.hpp"

using nlohmann::json;

namespace {

/// Curves of an SVG, by the class that names their solver.
struct SvgVisitor {
    std::string root;
    std::map<std::string, int> curves;

    void open(const std::string& name, const XmlReader::Attributes& attributes,
              const std::vector<std::string>&) {
        if (root.empty()) root = name;
        if (name != "polyline") return;
        CHECK(attributes.at("points").find("nan") == std::string::npos);
        CHECK(attributes.at("points").find(',') != std::string::npos);
        ++curves[attributes.at("class")];
    }
    void text(const std::string&) {}
};

}  // namespace

TEST_CASE("App: bench writes numbers of every solver it was asked for, and a plot of them",
          "[long]") {
    const Workplace place;
    place.write("wall.toml", scenes::kBreaking);
    const Result result =
        place.run({"bench", "wall.toml", "--quick", "--solvers", "gather,scatter,reference",
                   "--json", "a.json", "--svg", "a.svg"});
    INFO(result.command << "\nstderr: " << result.err);
    REQUIRE(result.exitCode == 0);
    CHECK(result.err.empty());
    const json report = place.readJson("a.json");
    checkBenchResults(report, 5 * scenes::kCells, 50);
    CHECK(contains(result.out, report.at("gl_renderer")));
    CHECK(contains(result.out, report.at("machine")));

    std::map<std::string, std::set<std::string>> parts;
    for (const json& entry : report.at("results")) {
        parts[entry.at("solver")].insert(entry.at("part").get<std::string>());
        const bool drawn = entry.at("part") == "frames" || entry.at("part") == "one-step";
        CHECK(entry.at("ms_per_frame_drawn").is_number() == drawn);
        if (entry.at("solver") == "reference") continue;
        // At least two copies of 8 nodes of 2 vectors each per 5 tetrahedra.
        CHECK(entry.at("bytes_per_tetrahedron") >= 2 * 8 * 32 / 5);
        CHECK(entry.at("bytes_per_tetrahedron") < 100'000);
    }
    const std::set<std::string> all{"frames", "one-step", "calm", "explosions", "intact", "broken"};
    CHECK(parts == decltype(parts){{"gather", all}, {"scatter", all}, {"reference", all}});

    REQUIRE(report.at("drawn").size() == 2);
    for (const json& drawn : report.at("drawn")) {
        INFO(drawn.dump());
        CHECK(drawn.at("cells") == scenes::kCells);
        // At least six faces of two triangles for each cell.
        CHECK(drawn.at("triangles") >= 12 * scenes::kCells);
        CHECK(drawn.at("vertices") >= 24 * scenes::kCells);
        CHECK(drawn.at("ms_display").get<double>() > 0);
        CHECK(drawn.at("ms_simulation").get<double>() > 0);
        CHECK(drawn.at("ms_surface").get<double>() > 0);
        CHECK(drawn.at("ms_gather").get<double>() > 0);
    }
    std::set<std::string> throughLibrary;
    for (const json& entry : report.at("library")) {
        INFO(entry.dump());
        throughLibrary.insert(entry.at("solver").get<std::string>());
        CHECK(entry.at("ms_solver").get<double>() > 0);
        CHECK(entry.at("ms_library").get<double>() > 0);
        CHECK(entry.at("ms_look").get<double>() > 0);
        CHECK(entry.at("ms_extend").get<double>() > 0);
        CHECK(entry.at("ratio").get<double>() > 0);
        CHECK(entry.at("frames") >= 2);
    }
    CHECK(throughLibrary == std::set<std::string>{"cpu", "gather"});
    CHECK(report.at("ms_display_mesh_build").get<double>() > 0);

    std::map<std::string, std::set<std::string>> passes;
    for (const json& pass : report.at("passes")) {
        INFO(pass.dump());
        passes[pass.at("solver")].insert(pass.at("pass").get<std::string>());
        CHECK(pass.at("ms").get<double>() >= 0);
        CHECK(pass.at("runs_per_frame").get<double>() > 0);
        CHECK(pass.at("runs_per_frame").get<double>() <= 50);
    }
    for (const char* solver : {"gather", "scatter"}) {
        INFO(solver);
        CHECK(passes[solver].count("elements") == 1);
        CHECK(passes[solver].count("nodes") == 1);
        CHECK(passes[solver].size() >= 4);  // and what breaks bonds
    }

    SvgVisitor svg;
    const std::string text = place.read("a.svg");
    XmlReader(text).read(svg);
    CHECK(svg.root == "svg");
    // Cost and throughput.
    CHECK(svg.curves ==
          std::map<std::string, int>{{"gather", 2}, {"scatter", 2}, {"reference", 2}});
}
