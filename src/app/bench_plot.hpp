#pragma once
#include <string>
#include <utility>
#include <vector>

namespace sunder::app {

struct PlotSeries {
    std::string label;
    std::vector<std::pair<double, double>> points;  ///< both greater than 0, x rising
};

/// One coordinate system, both axes logarithmic.
struct PlotPanel {
    std::string xLabel, yLabel;
    std::vector<PlotSeries> series;
};

/// An SVG picture: panels side by side, one legend for all (series of one label have one colour).
std::string plotSvg(const std::string& title, const std::string& subtitle,
                    const std::vector<PlotPanel>& panels);

}  // namespace sunder::app
