#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace sunder::core {

/// How messages show what a user wrote: whatever it was, the message stays one readable line.

/// The text with control characters, invisible and direction-changing characters and invalid UTF-8
/// escaped, cut after `maxCharacters` (then "…" follows).
std::string printable(std::string_view text, std::size_t maxCharacters);

/// The text in single quotes, printable, cut at 60 characters.
std::string inQuotes(std::string_view text);

/// The shortest decimal that reads back as the same number: "0.3", "120", "1e12", "nan".
std::string formatNumber(double value);

/// "KEY: number 2" of a list.
std::string component(std::string_view key, int index);

/// "body 'wall'", or "body 3" where it has no name, of the third.
std::string called(std::string_view kind, std::string_view name, std::size_t index);

/// Why a text is not one line of 1 to `maxCharacters` bytes of UTF-8 without control characters;
/// empty: it is.
std::string lineProblem(std::string_view key, std::string_view text, std::size_t maxCharacters);

/// "a, b, c".
std::string joined(std::span<const std::string> names);
std::string joined(std::span<const std::string_view> names);

/// "; did you mean 'frames'?" when a candidate is spelt like `name`, otherwise nothing.
std::string suggestion(std::string_view name, std::span<const std::string> candidates);
std::string suggestion(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace sunder::core
