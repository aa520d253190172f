#pragma once
#include <string>
#include <vector>

namespace sunder::app {

/// Three significant digits without an exponent: 0.0123, 1.23, 1,230.
std::string shortNumber(double value);
/// 2,000,000
std::string withCommas(long long value);

/// Rows of text in columns, the first row a heading. The first column is flush left, numbers are
/// flush right.
std::string textTable(const std::vector<std::vector<std::string>>& rows);

}  // namespace sunder::app
