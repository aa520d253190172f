#pragma once
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

/// One axis of a plot.
struct Axis {
    std::string label, unit;
    bool log = false;
};

enum class LineStyle { Line, Dashed, Points };

using PlotPoints = std::vector<std::array<double, 2>>;

/// What one check leaves for a reader: its plots and figures, in report/physics/NAME.json of the
/// build folder. Written when it goes, so also when the check fails; one that was cut short has a
/// figure that says so.
class PhysicsReport {
  public:
    class Plot {
      public:
        /// Long series are thinned to 400 points.
        void series(const std::string& label, LineStyle style, const PlotPoints& points);

      private:
        friend class PhysicsReport;
        Plot(nlohmann::json& plots, std::size_t index) : plots_(plots), index_(index) {}
        nlohmann::json& plots_;
        std::size_t index_;
    };

    /// claim: in one sentence, what is compared with what, and the source.
    PhysicsReport(const std::string& name, const std::string& title, const std::string& claim);
    ~PhysicsReport();
    PhysicsReport(const PhysicsReport&) = delete;
    PhysicsReport& operator=(const PhysicsReport&) = delete;

    Plot plot(const std::string& title, const Axis& x, const Axis& y);
    /// Notes the figure, then CHECKs that it is off by no more than a share `tolerance` of
    /// `expected`.
    void checkRelative(const std::string& what, double measured, double expected,
                       const std::string& unit, double tolerance);
    /// The same with a tolerance in `unit`.
    void checkAbsolute(const std::string& what, double measured, double expected,
                       const std::string& unit, double tolerance);

  private:
    void check(nlohmann::json figure, double allowed);

    std::string name_;
    int exceptions_;  ///< on their way when the check began
    nlohmann::json json_;
};
