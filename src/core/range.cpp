#include "core/range.hpp"

#include <cmath>

#include "core/wording.hpp"

namespace sunder::core {

bool Range::contains(double value) const {
    // Written so that NaN fails every comparison.
    return std::isfinite(value) && (minExcluded ? value > min : value >= min) &&
           (maxExcluded ? value < max : value <= max);
}

double Range::least() const {
    return minExcluded ? std::nextafter(min, max) : min;
}

double Range::most() const {
    return maxExcluded ? std::nextafter(max, min) : max;
}

WholeRange wholeRange(const Range& range) {
    return {static_cast<std::int64_t>(range.min), static_cast<std::int64_t>(range.max)};
}

std::string toString(const Range& r) {
    const std::string min = formatNumber(r.min);
    const std::string max = formatNumber(r.max);
    const std::string unit = r.unit == "1" ? "" : " " + std::string(r.unit);
    if (!r.minExcluded && !r.maxExcluded) return "from " + min + " to " + max + unit;
    return (r.minExcluded ? "greater than " : "at least ") + min + " and " +
           (r.maxExcluded ? "less than " : "at most ") + max + unit;
}

std::string toString(const WholeRange& r) {
    return "a whole number from " + std::to_string(r.min) + " to " + std::to_string(r.max);
}

}  // namespace sunder::core
