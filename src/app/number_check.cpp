#include "app/number_check.hpp"

#include <charconv>
#include <string>

namespace sunder::app {
namespace {

/// `accepts` says whether a text is `what`.
template <class Accepts>
CLI::Validator check(const std::string& what, Accepts accepts) {
    return CLI::Validator(
        [what, accepts](std::string& text) {
            return accepts(text) ? std::string() : "'" + text + "' is not " + what;
        },
        "");
}

}  // namespace

CLI::Validator wholeNumber(std::uint64_t min, std::uint64_t max) {
    return check("a whole number from " + std::to_string(min) + " to " + std::to_string(max),
                 [min, max](const std::string& text) {
                     std::uint64_t value = 0;
                     const char* end = text.data() + text.size();
                     const auto result = std::from_chars(text.data(), end, value);
                     return result.ec == std::errc() && result.ptr == end && value >= min &&
                            value <= max;
                 });
}

CLI::Validator number(int min, int max) {
    return check("a number from " + std::to_string(min) + " to " + std::to_string(max),
                 [min, max](const std::string& text) {
                     double value = 0;
                     return CLI::detail::lexical_cast(text, value) && value >= min && value <= max;
                 });
}

}  // namespace sunder::app
