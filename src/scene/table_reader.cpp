#include "scene/table_reader.hpp"

#include <algorithm>
#include <cmath>

#include "scene/wording.hpp"

namespace sunder::scene {

using namespace core;

namespace {

/// "not -5", "not the string 'abc'", …
std::string butIs(const toml::node& node) {
    if (const auto* v = node.as_integer()) return ", not " + std::to_string(v->get());
    if (const auto* v = node.as_floating_point()) return ", not " + formatNumber(v->get());
    if (const auto* v = node.as_boolean()) return v->get() ? ", not true" : ", not false";
    if (const auto* v = node.as_string()) return ", not the text " + inQuotes(v->get());
    if (const auto* v = node.as_array()) return ", not a list of " + std::to_string(v->size());
    if (node.is_table()) return ", not a table";
    return ", not a date or time";
}

std::string allowed(const Range& r) {
    const std::string min = formatNumber(r.min);
    const std::string max = formatNumber(r.max);
    const std::string unit = r.unit == "1" ? "" : " " + std::string(r.unit);
    if (!r.minExcluded && !r.maxExcluded) return "from " + min + " to " + max + unit;
    return (r.minExcluded ? "greater than " : "at least ") + min + " and " +
           (r.maxExcluded ? "less than " : "at most ") + max + unit;
}

std::string allowed(const WholeRange& r) {
    return "a whole number from " + std::to_string(r.min) + " to " + std::to_string(r.max);
}

bool contains(const Range& r, double v) {
    // Written so that NaN fails every comparison.
    return std::isfinite(v) && (r.minExcluded ? v > r.min : v >= r.min) &&
           (r.maxExcluded ? v < r.max : v <= r.max);
}

std::string component(std::string_view key, std::size_t index) {
    return std::string(key) + ": number " + std::to_string(index + 1);
}

}  // namespace

TableReader::TableReader(const toml::table& root, std::string file, std::string what, Keys known)
    : table_(&root), file_(printable(file, 300)), what_(std::move(what)), isRoot_(true) {
    refuseUnknownKeys(known);
}

TableReader::TableReader(const TableReader& parent, const toml::table& table, std::string what,
                         Keys known)
    : table_(&table), file_(parent.file_), what_(std::move(what)), isRoot_(false) {
    refuseUnknownKeys(known);
}

void TableReader::refuseUnknownKeys(const Keys& known) const {
    for (const auto& [key, node] : *table_) {
        if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
        const std::span<const std::string_view> names(known);
        throw InputError(location(key.source().begin.line) + "unknown key " + inQuotes(key.str()) +
                         " in " + what_ + suggestion(key.str(), names) +
                         " (known: " + joined(names) + ")");
    }
}

std::string TableReader::location(std::uint32_t line) const {
    return file_ + (line > 0 ? ":" + std::to_string(line) : "") + ": ";
}

std::string TableReader::where() const {
    return location(isRoot_ ? 0 : table_->source().begin.line) + what_;
}

std::string TableReader::where(std::string_view key) const {
    const toml::node* node = table_->get(key);
    const std::uint32_t line = (node ? *node : *table_).source().begin.line;
    return location(isRoot_ && !node ? 0 : line) + (isRoot_ ? "" : what_ + ": ") + std::string(key);
}

void TableReader::failAt(const toml::node* node, const std::string& problem) const {
    // The root has no line of its own.
    std::uint32_t line = node && !(isRoot_ && node == table_) ? node->source().begin.line : 0;
    if (line == 0 && !isRoot_) line = table_->source().begin.line;
    throw InputError(location(line) + (isRoot_ ? "" : what_ + ": ") + problem);
}

void TableReader::fail(std::string_view key, const std::string& problem) const {
    const toml::node* node = key.empty() ? nullptr : table_->get(key);
    failAt(node ? node : table_, problem);
}

void TableReader::require(std::string_view key, std::string_view hint) const {
    if (!has(key)) fail(std::string(key) + " is missing; give " + std::string(hint));
}

bool TableReader::read(std::string_view key, bool& value) const {
    const toml::node* node = table_->get(key);
    if (!node) return false;
    if (!node->is_boolean())
        failAt(node, std::string(key) + " must be true or false" + butIs(*node));
    value = node->as_boolean()->get();
    return true;
}

double TableReader::number(const toml::node& node, const std::string& name, const Range& range,
                           const char* article) const {
    if (!node.is_number())
        failAt(&node, name + " must be " + article + allowed(range) + butIs(node));
    const double value = node.is_integer() ? static_cast<double>(node.as_integer()->get())
                                           : node.as_floating_point()->get();
    if (!contains(range, value)) failAt(&node, name + " must be " + allowed(range) + butIs(node));
    return value;
}

std::int64_t TableReader::wholeNumber(const toml::node& node, const std::string& name,
                                      const WholeRange& range) const {
    std::optional<std::int64_t> value;
    if (const auto* integer = node.as_integer()) {
        value = integer->get();
    } else if (const auto* floating = node.as_floating_point()) {
        // Above 2^53 a double no longer tells neighbouring whole numbers apart.
        const double v = floating->get();
        if (std::abs(v) <= 9007199254740992.0 && v == std::floor(v))
            value = static_cast<std::int64_t>(v);
    }
    if (!value || *value < range.min || *value > range.max)
        failAt(&node, name + " must be " + allowed(range) + butIs(node));
    return *value;
}

bool TableReader::read(std::string_view key, double& value, const Range& range) const {
    const toml::node* node = table_->get(key);
    if (!node) return false;
    value = number(*node, std::string(key), range, "a number ");
    return true;
}

bool TableReader::read(std::string_view key, std::int64_t& value, const WholeRange& range) const {
    const toml::node* node = table_->get(key);
    if (!node) return false;
    value = wholeNumber(*node, std::string(key), range);
    return true;
}

bool TableReader::read(std::string_view key, int& value, const WholeRange& range) const {
    std::int64_t wide = value;
    if (!read(key, wide, range)) return false;
    value = static_cast<int>(wide);
    return true;
}

const toml::array& TableReader::list(const toml::node& node, std::string_view key, std::size_t size,
                                     const std::string& kind) const {
    const toml::array* array = node.as_array();
    if (!array || array->size() != size)
        failAt(&node, std::string(key) + " must be a list of " + kind + butIs(node));
    return *array;
}

bool TableReader::read(std::string_view key, IVec3& value, const WholeRange& range) const {
    const toml::node* node = table_->get(key);
    if (!node) return false;
    const toml::array& array = list(*node, key, 3, "three whole numbers");
    for (std::size_t i = 0; i < 3; ++i)
        value[static_cast<int>(i)] =
            static_cast<int>(wholeNumber(array[i], component(key, i), range));
    return true;
}

bool TableReader::read(std::string_view key, Vec3& value, const Range& range, bool single) const {
    const toml::node* node = table_->get(key);
    if (!node) return false;
    if (single && node->is_number()) {
        value.setConstant(number(*node, std::string(key), range, "a number "));
        return true;
    }
    const toml::array& array =
        list(*node, key, 3,
             std::string("three numbers") + (single ? ", or one number for all three" : ""));
    for (std::size_t i = 0; i < 3; ++i)
        value[static_cast<int>(i)] = number(array[i], component(key, i), range, "a number ");
    return true;
}

bool TableReader::read(std::string_view key, std::array<double, 2>& value,
                       const Range& range) const {
    const toml::node* node = table_->get(key);
    if (!node) return false;
    const toml::array& array = list(*node, key, 2, "two numbers");
    for (std::size_t i = 0; i < 2; ++i)
        value[i] = number(array[i], component(key, i), range, "a number ");
    if (!(value[0] < value[1]))
        failAt(node, std::string(key) + ": number 2 must be greater than number 1, " +
                         formatNumber(value[0]) + ", not " + formatNumber(value[1]));
    return true;
}

std::string TableReader::line(const toml::node& node, const std::string& name,
                              std::size_t maxCharacters) const {
    const toml::value<std::string>* text = node.as_string();
    if (!text) failAt(&node, name + " must be a text in quotes" + butIs(node));
    const std::string& value = text->get();
    if (value.empty()) failAt(&node, name + " must not be empty");
    if (value.size() > maxCharacters)
        failAt(&node, name + " must be at most " + std::to_string(maxCharacters) +
                          " characters long" + butIs(node));
    const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
    if (std::any_of(value.begin(), value.end(), isControl))
        failAt(&node, name + " must be one line without control characters" + butIs(node));
    return value;
}

bool TableReader::read(std::string_view key, std::string& value, std::size_t maxCharacters) const {
    const toml::node* node = table_->get(key);
    if (!node) return false;
    value = line(*node, std::string(key), maxCharacters);
    return true;
}

std::size_t TableReader::choice(const toml::node& node, const std::string& name,
                                std::span<const std::string_view> names) const {
    const auto* text = node.as_string();
    const auto found =
        text ? std::find(names.begin(), names.end(), std::string_view(text->get())) : names.end();
    if (found == names.end())
        failAt(&node, name + " must be one of " + joined(names) + butIs(node) +
                          (text ? suggestion(text->get(), names) : ""));
    return static_cast<std::size_t>(found - names.begin());
}

std::optional<std::size_t> TableReader::readChoice(std::string_view key,
                                                   std::span<const std::string_view> names) const {
    const toml::node* node = table_->get(key);
    if (!node) return std::nullopt;
    return choice(*node, std::string(key), names);
}

std::vector<std::size_t> TableReader::readChoices(std::string_view key,
                                                  std::span<const std::string_view> names) const {
    std::vector<std::size_t> result;
    const toml::node* node = table_->get(key);
    if (!node) return result;
    const toml::array* array = node->as_array();
    if (!array)
        failAt(node, std::string(key) + " must be a list such as [\"" + std::string(names[0]) +
                         "\"]" + butIs(*node));
    for (const toml::node& element : *array) {
        const std::size_t index = choice(element, "each of " + std::string(key), names);
        if (std::find(result.begin(), result.end(), index) != result.end())
            failAt(&element, std::string(key) + " names " + inQuotes(names[index]) +
                                 " twice; once is enough");
        result.push_back(index);
    }
    return result;
}

std::optional<TableReader> TableReader::table(std::string_view key, Keys known) const {
    const toml::node* node = table_->get(key);
    if (!node) return std::nullopt;
    const std::string name(key);
    if (!node->is_table())
        failAt(node, name + " must be one table, headed [" + name + "]" + butIs(*node));
    return TableReader(*this, *node->as_table(), name, std::move(known));
}

std::vector<TableReader> TableReader::tables(std::string_view key, const Keys& known,
                                             std::size_t maxCount) const {
    std::vector<TableReader> result;
    const toml::node* node = table_->get(key);
    if (!node) return result;
    const std::string name(key);
    const std::string header =
        "[[" + (isRoot_ ? "" : what_.substr(0, what_.find(' ')) + ".") + name + "]]";
    const toml::array* array = node->as_array();
    if (!array)
        failAt(node, name + " must be a list of tables, each headed " + header + butIs(*node));
    if (array->size() > maxCount)
        failAt(node, "there are " + std::to_string(array->size()) + " tables " + header +
                         "; at most " + std::to_string(maxCount) + " are allowed");
    for (const toml::node& element : *array) {
        if (!element.is_table())
            failAt(&element,
                   "each " + name + " must be a table, headed " + header + butIs(element));
        const std::string label = name + " " + std::to_string(result.size() + 1);
        result.push_back(TableReader(*this, *element.as_table(),
                                     isRoot_ ? label : label + " of " + what_, known));
    }
    return result;
}

std::vector<std::pair<std::string, TableReader>> TableReader::namedTables(
    std::string_view key, const Keys& known, std::size_t maxCount) const {
    std::vector<std::pair<std::string, TableReader>> result;
    const toml::node* node = table_->get(key);
    if (!node) return result;
    const std::string name(key);
    const toml::table* table = node->as_table();
    if (!table)
        failAt(node, name + " must be tables, each headed [" + name + ".NAME]" + butIs(*node));
    if (table->size() > maxCount)
        failAt(node, "there are " + std::to_string(table->size()) + " tables [" + name +
                         ".NAME]; at most " + std::to_string(maxCount) + " are allowed");
    for (const auto& [child, value] : *table) {
        const std::string label = name + " " + inQuotes(child.str());
        if (!value.is_table())
            failAt(&value, label + " must be a table, headed [" + name + ".NAME]" + butIs(value));
        result.emplace_back(std::string(child.str()),
                            TableReader(*this, *value.as_table(), label, known));
    }
    return result;
}

}  // namespace sunder::scene
