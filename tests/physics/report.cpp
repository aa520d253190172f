#include "physics/report.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "gpu/test_context.hpp"

namespace {

constexpr std::size_t kMostPoints = 400;
constexpr const char* kStyles[] = {"line", "dashed", "points"};

nlohmann::json toJson(const Axis& axis) {
    return {{"label", axis.label}, {"unit", axis.unit}, {"log", axis.log}};
}

}  // namespace

PhysicsReport::PhysicsReport(const std::string& name, const std::string& title,
                             const std::string& claim)
    : name_(name),
      exceptions_(std::uncaught_exceptions()),
      json_{{"name", name},
            {"title", title},
            {"claim", claim},
            {"driver", testContext().info().renderer + ", OpenGL " + testContext().info().version},
            {"plots", nlohmann::json::array()},
            {"figures", nlohmann::json::array()}} {}

PhysicsReport::~PhysicsReport() {
    if (std::uncaught_exceptions() > exceptions_)
        json_["figures"].push_back({{"what", "the check reached its end"},
                                    {"measured", 0},
                                    {"expected", 1},
                                    {"unit", "1"},
                                    {"tolerance", 0},
                                    {"relative", false},
                                    {"holds", false}});
    const std::filesystem::path folder = SUNDER_PHYSICS_REPORT;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::ofstream(folder / (name_ + ".json")) << json_.dump(1) << '\n';
}

PhysicsReport::Plot PhysicsReport::plot(const std::string& title, const Axis& x, const Axis& y) {
    json_["plots"].push_back({{"title", title},
                              {"x", toJson(x)},
                              {"y", toJson(y)},
                              {"series", nlohmann::json::array()}});
    return {json_["plots"], json_["plots"].size() - 1};
}

void PhysicsReport::Plot::series(const std::string& label, LineStyle style,
                                 const PlotPoints& points) {
    const std::size_t stride = (points.size() + kMostPoints - 1) / kMostPoints;
    PlotPoints kept;
    for (std::size_t i = 0; i < points.size(); i += stride) kept.push_back(points[i]);
    plots_[index_]["series"].push_back(
        {{"label", label}, {"style", kStyles[static_cast<int>(style)]}, {"points", kept}});
}

void PhysicsReport::checkRelative(const std::string& what, double measured, double expected,
                                  const std::string& unit, double tolerance) {
    check({{"what", what},
           {"measured", measured},
           {"expected", expected},
           {"unit", unit},
           {"tolerance", tolerance},
           {"relative", true}},
          tolerance * std::abs(expected));
}

void PhysicsReport::checkAbsolute(const std::string& what, double measured, double expected,
                                  const std::string& unit, double tolerance) {
    check({{"what", what},
           {"measured", measured},
           {"expected", expected},
           {"unit", unit},
           {"tolerance", tolerance},
           {"relative", false}},
          tolerance);
}

void PhysicsReport::check(nlohmann::json figure, double allowed) {
    const double measured = figure["measured"], expected = figure["expected"];
    const bool holds = std::abs(measured - expected) <= allowed;
    figure["holds"] = holds;
    INFO(figure["what"].get<std::string>() << ": " << measured << ", expected " << expected << " ± "
                                           << allowed << " " << figure["unit"].get<std::string>());
    json_["figures"].push_back(std::move(figure));
    CHECK(holds);
}
