#include "app/bench_plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/bench_table.hpp"

namespace sunder::app {
namespace {

constexpr double kPanelWidth = 380, kPanelHeight = 300;
constexpr double kLeft = 78, kTop = 112, kBottom = 58, kGap = 92, kRight = 26;
// Okabe and Ito's colours: told apart by everyone; in another order, darker ones first.
constexpr const char* kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                    "#000000", "#e69f00", "#56b4e9"};

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return result;
}

std::string fixed(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

std::string text(double x, double y, const std::string& attributes, const std::string& words) {
    return "<text x=\"" + fixed(x) + "\" y=\"" + fixed(y) + "\" " + attributes + ">" +
           escaped(words) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const char* colour) {
    return "<line x1=\"" + fixed(x1) + "\" y1=\"" + fixed(y1) + "\" x2=\"" + fixed(x2) +
           "\" y2=\"" + fixed(y2) + "\" stroke=\"" + colour + "\"/>\n";
}

/// From numbers to places, along one axis.
struct Axis {
    double low = 0, high = 1;  ///< decimal logarithms
    double from = 0, to = 1;   ///< places of low and high

    double place(double value) const {
        return from + (to - from) * (std::log10(value) - low) / (high - low);
    }
    /// Round numbers 1, 2, 5 times a power of ten within the axis.
    std::vector<double> ticks() const {
        std::vector<double> result;
        for (int power = static_cast<int>(std::floor(low)); power <= high; ++power)
            for (const double factor : {1., 2., 5.}) {
                const double value = factor * std::pow(10, power);
                if (std::log10(value) >= low - 1e-9 && std::log10(value) <= high + 1e-9)
                    result.push_back(value);
            }
        return result;
    }
};

/// An axis that holds all of `values`, with a little room on both sides.
Axis fit(const std::vector<double>& values, double from, double to) {
    Axis axis{0, 1, from, to};
    if (!values.empty()) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        axis.low = std::log10(*low);
        axis.high = std::log10(*high);
    }
    const double room = std::max(0.05 * (axis.high - axis.low), 0.15);
    axis.low -= room;
    axis.high += room;
    return axis;
}

/// Labels stay narrow: 2,000,000 as 2M, 0.50 as 0.5.
std::string tickLabel(double value) {
    const char* unit = "";
    if (value >= 1e4) {
        unit = value >= 1e6 ? "M" : "k";
        value /= value >= 1e6 ? 1e6 : 1e3;
    }
    std::string number = shortNumber(value);
    if (number.find('.') != std::string::npos) {
        number.erase(number.find_last_not_of('0') + 1);
        if (number.back() == '.') number.pop_back();
    }
    return number + unit;
}

class PanelWriter {
  public:
    PanelWriter(const PlotPanel& panel, double left, const std::vector<std::string>& labels)
        : panel_(panel), labels_(labels), left_(left) {
        std::vector<double> xs, ys;
        for (const PlotSeries& series : panel.series)
            for (const auto& [x, y] : series.points) {
                xs.push_back(x);
                ys.push_back(y);
            }
        x_ = fit(xs, left, left + kPanelWidth);
        y_ = fit(ys, kTop + kPanelHeight, kTop);
    }

    std::string write() const {
        std::string svg = grid();
        for (const PlotSeries& series : panel_.series) svg += curve(series);
        return svg;
    }

  private:
    std::string grid() const {
        std::string svg;
        for (const double value : x_.ticks()) {
            const double x = x_.place(value);
            svg += line(x, kTop, x, kTop + kPanelHeight, "#e4e4e4");
            // Only whole powers on an axis of many decades, or labels touch.
            const double digit = value / std::pow(10, std::floor(std::log10(value) + 1e-9));
            if (x_.high - x_.low > 3.6 && digit > 1.5) continue;
            svg += text(x, kTop + kPanelHeight + 18, "text-anchor=\"middle\"", tickLabel(value));
        }
        for (const double value : y_.ticks()) {
            const double y = y_.place(value);
            svg += line(left_, y, left_ + kPanelWidth, y, "#e4e4e4");
            svg += text(left_ - 8, y + 4, "text-anchor=\"end\"", tickLabel(value));
        }
        svg += "<rect x=\"" + fixed(left_) + "\" y=\"" + fixed(kTop) + "\" width=\"" +
               fixed(kPanelWidth) + "\" height=\"" + fixed(kPanelHeight) +
               "\" fill=\"none\" stroke=\"#666666\"/>\n";
        const double middle = kTop + kPanelHeight / 2;
        svg += text(left_ + kPanelWidth / 2, kTop + kPanelHeight + 42, "text-anchor=\"middle\"",
                    panel_.xLabel);
        svg += text(left_ - 58, middle,
                    "text-anchor=\"middle\" transform=\"rotate(-90 " + fixed(left_ - 58) + " " +
                        fixed(middle) + ")\"",
                    panel_.yLabel);
        return svg;
    }

    std::string curve(const PlotSeries& series) const {
        const auto known = std::find(labels_.begin(), labels_.end(), series.label);
        const auto index = static_cast<std::size_t>(known - labels_.begin());
        const std::string colour = kColours[index % std::size(kColours)];
        std::string places, dots;
        for (const auto& [x, y] : series.points) {
            const std::string px = fixed(x_.place(x)), py = fixed(y_.place(y));
            places += (places.empty() ? "" : " ") + px + "," + py;
            dots +=
                "<circle cx=\"" + px + "\" cy=\"" + py + "\" r=\"3.5\" fill=\"" + colour + "\"/>\n";
        }
        return "<polyline class=\"" + escaped(series.label) + "\" points=\"" + places +
               "\" fill=\"none\" stroke-width=\"2\" stroke=\"" + colour + "\"/>\n" + dots;
    }

    const PlotPanel& panel_;
    const std::vector<std::string>& labels_;
    double left_;
    Axis x_, y_;
};

}  // namespace

std::string plotSvg(const std::string& title, const std::string& subtitle,
                    const std::vector<PlotPanel>& panels) {
    std::vector<std::string> labels;
    for (const PlotPanel& panel : panels)
        for (const PlotSeries& series : panel.series)
            if (std::find(labels.begin(), labels.end(), series.label) == labels.end())
                labels.push_back(series.label);

    const auto count = static_cast<double>(panels.size());
    const double width = kLeft + count * kPanelWidth + (count - 1) * kGap + kRight;
    const double height = kTop + kPanelHeight + kBottom;
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + fixed(width) +
                      "\" height=\"" + fixed(height) + "\" viewBox=\"0 0 " + fixed(width) + " " +
                      fixed(height) + "\" font-family=\"sans-serif\" font-size=\"13\">\n";
    svg += "<rect width=\"" + fixed(width) + "\" height=\"" + fixed(height) +
           "\" fill=\"#ffffff\"/>\n";
    svg += text(kLeft, 32, "font-size=\"18\" font-weight=\"bold\"", title);
    svg += text(kLeft, 54, "fill=\"#555555\"", subtitle);
    double x = kLeft;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const char* colour = kColours[i % std::size(kColours)];
        svg += line(x, 80, x + 24, 80, colour);
        svg +=
            "<circle cx=\"" + fixed(x + 12) + "\" cy=\"80\" r=\"3.5\" fill=\"" + colour + "\"/>\n";
        svg += text(x + 30, 84.5, "class=\"legend\"", labels[i]);
        x += 56 + 7.5 * static_cast<double>(labels[i].size());
    }
    double left = kLeft;
    for (const PlotPanel& panel : panels) {
        svg += PanelWriter(panel, left, labels).write();
        left += kPanelWidth + kGap;
    }
    return svg + "</svg>\n";
}

}  // namespace sunder::app
