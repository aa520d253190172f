#include "app/support/bench_report.hpp"

#include "catch.hpp"

using nlohmann::json;

void checkBenchResults(const json& report, int tetrahedra, int steps) {
    CHECK_FALSE(report.at("machine").get<std::string>().empty());
    CHECK(report.at("cores") >= 1);
    CHECK(report.at("gl_renderer").is_string());
    CHECK(report.at("passes").is_array());
    CHECK(report.at("skipped").empty());
    REQUIRE_FALSE(report.at("results").empty());
    for (const json& result : report.at("results")) {
        INFO(result.dump());
        CHECK(result.at("scene") == "wall");
        CHECK(result.at("tetrahedra") == tetrahedra);
        CHECK(result.at("threads") >= 1);
        const int perFrame = result.at("steps_per_frame");
        CHECK(perFrame == (result.at("part") == "one-step" ? 1 : steps));
        const double step = result.at("ms_per_step"), frame = result.at("ms_per_frame");
        CHECK(step > 0);
        CHECK(frame == Approx(step * perFrame));
        CHECK(result.at("mtets_per_s").get<double>() == Approx(tetrahedra / step / 1000));
        CHECK(result.at("ns_per_tetrahedron").get<double>() == Approx(step * 1e6 / tetrahedra));
        if (!result.at("ms_per_frame_worst").is_null()) {
            CHECK(result.at("part") == "frames");
            CHECK(result.at("ms_per_frame_breaking") > 0);
            CHECK(result.at("ms_per_frame_worst") >= result.at("ms_per_frame_breaking"));
        }
        CHECK(result.at("runs") >= 1);
        CHECK(result.at("steps_per_run") >= 1);
        const double broken = result.at("bonds_broken_share");
        CHECK(broken >= 0);
        CHECK(broken <= 1);
        CHECK((result.at("part") == "broken" || broken == 0));
    }
}
