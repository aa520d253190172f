#include "app/bench_report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/bench_plot.hpp"
#include "app/bench_table.hpp"

namespace sunder::app {
namespace {

using nlohmann::ordered_json;

std::string orDash(const std::optional<double>& value) {
    return value ? shortNumber(*value) : "-";
}

std::string perSecond(double milliseconds) {
    return milliseconds > 0 ? shortNumber(1000 / milliseconds) : "-";
}

template <class Number>
ordered_json orNull(const std::optional<Number>& value) {
    return value ? ordered_json(*value) : ordered_json();
}

std::vector<std::string> labelsOf(const Results& results) {
    std::vector<std::string> labels;
    for (const BenchResult& result : results)
        if (std::find(labels.begin(), labels.end(), result.label) == labels.end())
            labels.push_back(result.label);
    return labels;
}

/// The result of `label` at this size, if it was measured.
const BenchResult* find(const Results& results, const std::string& label, int tetrahedra) {
    for (const BenchResult& result : results)
        if (result.label == label && result.tetrahedra == tetrahedra && result.skipped.empty())
            return &result;
    return nullptr;
}

ordered_json toJson(const BenchResult& result) {
    return {{"part", result.part},
            {"scene", result.scene},
            {"solver", result.solver},
            {"threads", result.threads},
            {"bodies", result.bodies},
            {"tetrahedra", result.tetrahedra},
            {"steps_per_frame", result.stepsPerFrame},
            {"stiffness_limited", result.stiffnessLimited},
            {"ms_per_step", result.msPerStep},
            {"ms_per_frame", result.msPerFrame()},
            {"ms_per_frame_drawn", orNull(result.msPerFrameDrawn)},
            {"ms_per_frame_breaking", orNull(result.msPerFrameBreaking)},
            {"ms_per_frame_worst", orNull(result.msPerFrameWorst)},
            {"mtets_per_s", result.megaTetrahedraPerSecond()},
            {"ns_per_tetrahedron", result.nanosecondsPerTetrahedron()},
            {"bytes_per_tetrahedron", orNull(result.bytesPerTetrahedron)},
            {"bonds_broken_share", result.bondsBroken},
            {"steps_per_run", result.stepsPerRun},
            {"runs", result.runs}};
}

ordered_json skippedJson(const std::string& part, const std::string& scene,
                         const std::string& solver, int threads, int tetrahedra,
                         const std::string& why) {
    return {{"part", part},       {"scene", scene},           {"solver", solver},
            {"threads", threads}, {"tetrahedra", tetrahedra}, {"why", why}};
}

}  // namespace

std::string machineLine(const BenchReport& report) {
    return report.processor + ", " + std::to_string(report.cores) +
           (report.cores == 1 ? " core; " : " cores; ") +
           (report.renderer.empty() ? "no OpenGL"
                                    : report.renderer + ", OpenGL " + report.glVersion);
}

std::string benchJson(const BenchReport& report) {
    ordered_json results = ordered_json::array(), skipped = ordered_json::array(),
                 passes = ordered_json::array(), drawn = ordered_json::array(),
                 library = ordered_json::array();
    for (const BenchResult& result : report.results) {
        if (result.skipped.empty())
            results.push_back(toJson(result));
        else
            skipped.push_back(skippedJson(result.part, result.scene, result.solver, result.threads,
                                          result.tetrahedra, result.skipped));
    }
    for (const PassResult& pass : report.passes)
        passes.push_back({{"scene", pass.scene},
                          {"solver", pass.solver},
                          {"tetrahedra", pass.tetrahedra},
                          {"pass", pass.pass},
                          {"ms", pass.milliseconds},
                          {"runs_per_frame", pass.runsPerFrame}});
    for (const DrawingResult& result : report.drawn)
        drawn.push_back({{"scene", result.scene},
                         {"state", result.state},
                         {"bodies", result.bodies},
                         {"cells", result.cells},
                         {"vertices", result.vertices},
                         {"triangles", result.triangles},
                         {"ms_display", result.msDisplay},
                         {"ms_simulation", result.msSimulation},
                         {"ms_surface", result.msSurface},
                         {"ms_gather", result.msGather}});
    for (const LibraryResult& result : report.library) {
        if (!result.skipped.empty()) {
            skipped.push_back(skippedJson("library", result.scene, result.entrant.solver->name,
                                          result.entrant.threads, result.tetrahedra,
                                          result.skipped));
            continue;
        }
        library.push_back({{"scene", result.scene},
                           {"solver", result.entrant.solver->name},
                           {"threads", result.entrant.threads},
                           {"ms_solver", result.msSolver},
                           {"ms_library", result.msLibrary},
                           {"ratio", result.ratio},
                           {"ms_look", result.msLook},
                           {"ms_extend", result.msExtend},
                           {"frames", result.frames}});
    }
    const ordered_json json = {{"machine", report.processor},
                               {"cores", report.cores},
                               {"gl_renderer", report.renderer},
                               {"gl_version", report.glVersion},
                               {"results", results},
                               {"skipped", skipped},
                               {"passes", passes},
                               {"drawn", drawn},
                               {"library", library},
                               {"ms_display_mesh_build", orNull(report.msDisplayMeshBuild)}};
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string benchSvg(const BenchReport& report) {
    // The sizes where there are several, else the scene at its own steps.
    Results results;
    for (const char* part : {"scaling", "frames"}) {
        if (!results.empty()) break;
        for (const BenchResult& result : report.results)
            if (result.part == part) results.push_back(result);
    }
    PlotPanel cost{"tetrahedra", "ns per tetrahedron and step", {}};
    PlotPanel speed{"tetrahedra", "million tetrahedra per second", {}};
    for (const std::string& label : labelsOf(results)) {
        PlotSeries costs{label, {}}, speeds{label, {}};
        for (const BenchResult& result : results) {
            if (result.label != label || !result.skipped.empty()) continue;
            costs.points.emplace_back(result.tetrahedra, result.nanosecondsPerTetrahedron());
            speeds.points.emplace_back(result.tetrahedra, result.megaTetrahedraPerSecond());
        }
        if (costs.points.empty()) continue;
        cost.series.push_back(std::move(costs));
        speed.series.push_back(std::move(speeds));
    }
    return plotSvg("Sunder: one step of " + (results.empty() ? "nothing" : results.front().scene),
                   machineLine(report), {cost, speed});
}

std::string framesText(const Results& whole, const Results& oneStep) {
    std::vector<std::vector<std::string>> rows;
    const std::string steps =
        whole.empty() ? "" : std::to_string(whole.front().stepsPerFrame) + " steps";
    rows.push_back({"frames per second", steps, steps + ", drawn", "1 step", "1 step, drawn"});
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (!whole[i].skipped.empty()) continue;
        std::vector<std::string>& row = rows.emplace_back();
        row.push_back(whole[i].label);
        for (const BenchResult* result : {&whole[i], &oneStep[i]}) {
            row.push_back(perSecond(result->msPerFrame()));
            row.push_back(perSecond(result->msPerFrameDrawn.value_or(0)));
        }
    }
    return textTable(rows) + skippedText(whole);
}

std::string explosionsText(const Results& calm, const Results& explosions, int count) {
    constexpr double kLasts = 5e-3;  // s, as an event does unless it says otherwise
    std::vector<std::vector<std::string>> rows{{std::to_string(count) + " explosions at once",
                                                "ms a frame", "without", "us for one of 5 ms"}};
    for (std::size_t i = 0; i < calm.size(); ++i) {
        if (!calm[i].skipped.empty() || !explosions[i].skipped.empty()) continue;
        const double more = explosions[i].msPerStep - calm[i].msPerStep;
        const double steps = 60 * calm[i].stepsPerFrame * kLasts;
        rows.push_back({calm[i].label, shortNumber(explosions[i].msPerFrame()),
                        shortNumber(calm[i].msPerFrame()),
                        shortNumber(std::max(0.0, 1000 * more * steps / count))});
    }
    return textTable(rows);
}

std::string scalingText(const Results& results) {
    const std::vector<std::string> labels = labelsOf(results);
    std::vector<std::vector<std::string>> rows{{"tetrahedra"}};
    for (const std::string& label : labels) {
        rows[0].push_back(label + ": Mtet/s");
        rows[0].push_back("ns/tet");
    }
    std::vector<int> sizes;
    for (const BenchResult& result : results)
        if (sizes.empty() || sizes.back() != result.tetrahedra) sizes.push_back(result.tetrahedra);
    for (const int size : sizes) {
        std::vector<std::string>& row = rows.emplace_back();
        row.push_back(withCommas(size));
        for (const std::string& label : labels) {
            const BenchResult* result = find(results, label, size);
            row.push_back(result ? shortNumber(result->megaTetrahedraPerSecond()) : "-");
            row.push_back(result ? shortNumber(result->nanosecondsPerTetrahedron()) : "-");
        }
    }
    return textTable(rows) + skippedText(results);
}

std::string memoryText(const Results& results) {
    std::vector<std::vector<std::string>> rows{{"memory", "bytes per tetrahedron", "at"}};
    for (const std::string& label : labelsOf(results)) {
        const BenchResult* largest = nullptr;
        for (const BenchResult& result : results)
            if (result.label == label && result.skipped.empty()) largest = &result;
        if (largest)
            rows.push_back(
                {label, orDash(largest->bytesPerTetrahedron), withCommas(largest->tetrahedra)});
    }
    return textTable(rows);
}

std::string passesText(const std::vector<PassResult>& passes) {
    std::vector<std::vector<std::string>> rows{
        {"pass", "us per run", "runs per frame", "ms per frame", "share"}};
    for (const PassResult& pass : passes) {
        double whole = 0;
        for (const PassResult& other : passes)
            if (other.solver == pass.solver) whole += other.milliseconds * other.runsPerFrame;
        const double frame = pass.milliseconds * pass.runsPerFrame;
        rows.push_back({pass.solver + ": " + pass.pass, shortNumber(1000 * pass.milliseconds),
                        shortNumber(pass.runsPerFrame), shortNumber(frame),
                        whole > 0 ? shortNumber(100 * frame / whole) + " %" : "-"});
    }
    return textTable(rows);
}

std::string brokenText(const Results& intact, const Results& broken) {
    std::vector<std::vector<std::string>> rows{
        {"ms per step", "intact", "broken", "broken / intact"}};
    for (std::size_t i = 0; i < intact.size(); ++i)
        if (intact[i].skipped.empty() && broken[i].skipped.empty())
            rows.push_back({intact[i].label, shortNumber(intact[i].msPerStep),
                            shortNumber(broken[i].msPerStep),
                            shortNumber(broken[i].msPerStep / intact[i].msPerStep)});
    return textTable(rows) + skippedText(intact);
}

std::string breakingText(const Results& results) {
    std::vector<std::vector<std::string>> rows{
        {"ms per frame while bonds break", "median", "worst", "worst / median"}};
    for (const BenchResult& result : results)
        if (result.msPerFrameBreaking)
            rows.push_back({result.label, shortNumber(*result.msPerFrameBreaking),
                            shortNumber(*result.msPerFrameWorst),
                            shortNumber(*result.msPerFrameWorst / *result.msPerFrameBreaking)});
    return rows.size() > 1 ? textTable(rows) : "";
}

std::string peersText(const Results& results) {
    std::vector<std::vector<std::string>> rows{
        {"scene", "solver", "tetrahedra", "steps", "ms per 1/60 s", "frames/s", "worst frame, ms"}};
    for (const BenchResult& result : results)
        if (result.skipped.empty())
            rows.push_back({result.scene, result.label, withCommas(result.tetrahedra),
                            std::to_string(result.stepsPerFrame), shortNumber(result.msPerFrame()),
                            perSecond(result.msPerFrame()), orDash(result.msPerFrameWorst)});
    return textTable(rows) + skippedText(results);
}

std::string skippedText(const Results& results) {
    std::string text;
    for (const BenchResult& result : results)
        if (!result.skipped.empty())
            text += "  " + result.label + " left out at " + withCommas(result.tetrahedra) + ": " +
                    result.skipped + "\n";
    return text;
}

}  // namespace sunder::app
