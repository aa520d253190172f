#include "scene/table_reader.hpp"

#include <algorithm>
#include <cmath>

#include "core/wording.hpp"

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
                           bool whole) const {
    if (whole) return static_cast<double>(wholeNumber(node, name, wholeRange(range)));
    if (!node.is_number())
        failAt(&node, name + " must be a number " + toString(range) + butIs(node));
    const double value = node.is_integer() ? static_cast<double>(node.as_integer()->get())
                                           : node.as_floating_point()->get();
    if (!range.contains(value)) failAt(&node, name + " must be " + toString(range) + butIs(node));
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
    if (!value || !range.contains(*value))
        failAt(&node, name + " must be " + toString(range) + butIs(node));
    return *value;
}

bool TableReader::read(std::string_view key, std::int64_t& value, const WholeRange& range) const {
    const toml::node* node = table_->get(key);
    if (!node) return false;
    value = wholeNumber(*node, std::string(key), range);
    return true;
}

bool TableReader::holds(std::string_view key, std::string_view name) const {
    const toml::node* node = table_->get(key);
    const auto* text = node ? node->as_string() : nullptr;
    if (text && text->get() != name)
        failAt(node, std::string(key) + " must be a number or " + inQuotes(name) + butIs(*node));
    return text != nullptr;
}

const toml::array& TableReader::list(const toml::node& node, std::string_view key, std::size_t size,
                                     const std::string& kind) const {
    const toml::array* array = node.as_array();
    if (!array || array->size() != size)
        failAt(&node, std::string(key) + " must be a list of " + kind + butIs(node));
    return *array;
}

bool TableReader::readNumbers(std::string_view key, const Range& range, bool whole, bool single,
                              Numbers& numbers) const {
    const toml::node* node = table_->get(key);
    if (!node) return false;
    if (numbers.count == 1 || (single && node->is_number())) {
        numbers.values.fill(number(*node, std::string(key), range, whole));
        return true;
    }
    const toml::array& array =
        list(*node, key, static_cast<std::size_t>(numbers.count),
             std::string(numbers.count == 2 ? "two " : "three ") + (whole ? "whole " : "") +
                 "numbers" + (single ? ", or one number for all three" : ""));
    for (int i = 0; i < numbers.count; ++i) {
        const auto index = static_cast<std::size_t>(i);
        numbers.values[index] = number(array[index], component(key, i), range, whole);
    }
    checkNumbers(key, range, whole, numbers, complain());
    return true;
}

std::string TableReader::line(const toml::node& node, const std::string& name,
                              std::size_t maxCharacters) const {
    const toml::value<std::string>* text = node.as_string();
    if (!text) failAt(&node, name + " must be a text in quotes" + butIs(node));
    if (const std::string problem = lineProblem(name, text->get(), maxCharacters); !problem.empty())
        failAt(&node, problem);
    return text->get();
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
            failAt(&element, namedTwice(key, names[index]));
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
