#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace sunder::core {

/// What a number may be. Not-a-number and infinity never pass.
struct Range {
    double min;
    double max;
    std::string_view unit = "1";  ///< "Pa", "1/s", …; "1": a plain number
    bool minExcluded = false;     ///< the value must be greater than min
    bool maxExcluded = false;     ///< the value must be less than max

    bool contains(double value) const;
    /// The least and the greatest double that it contains.
    double least() const;
    double most() const;
    /// The number that it contains which is closest to this one, which is no NaN.
    double nearest(double value) const { return std::clamp(value, least(), most()); }
};

/// Both ends included.
struct WholeRange {
    std::int64_t min;
    std::int64_t max;

    bool contains(std::int64_t value) const { return value >= min && value <= max; }
};

/// Of a range of whole numbers that a double holds.
WholeRange wholeRange(const Range&);

/// "from 0 to 10 m", "greater than 0 and at most 1e15 Pa".
std::string toString(const Range&);
/// "a whole number from 1 to 100".
std::string toString(const WholeRange&);

}  // namespace sunder::core
