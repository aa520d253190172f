#include "app/bench_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sunder::app {

std::string withCommas(long long value) {
    std::string text = std::to_string(value);
    const int first = value < 0;
    for (int at = static_cast<int>(text.size()) - 3; at > first; at -= 3)
        text.insert(static_cast<std::size_t>(at), ",");
    return text;
}

std::string shortNumber(double value) {
    if (!std::isfinite(value)) return "-";
    if (std::abs(value) >= 999.5) return withCommas(std::llround(value));
    const double size = std::max(std::abs(value), 1e-6);
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 6);
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string textTable(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        if (widths.size() < row.size()) widths.resize(row.size());
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const auto& row : rows) {
        text += ' ';
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string padding(widths[i] - row[i].size(), ' ');
            text += "  " + (i == 0 ? row[i] + padding : padding + row[i]);
        }
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
    }
    return text;
}

}  // namespace sunder::app
