#include "app/support/program.hpp"
#include "catch.hpp"

TEST_CASE("App: info without a usable context says so, with exit code 3, and in its report") {
    const Workplace place;
    const Result result = place.run({"info", "--json", "info.json"}, kNoGl);
    CHECK(result.exitCode == 3);
    CHECK(result.err.rfind("sunder: SUNDER_EGL_DEVICE is '99'", 0) == 0);
    const nlohmann::json report = place.readJson("info.json");
    CHECK(contains(report.at("problem"), "99"));
    CHECK(report.count("picked") == 0);
    CHECK(report.at("devices").is_array());
}
