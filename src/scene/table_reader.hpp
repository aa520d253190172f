#pragma once
#include "scene/toml.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/check.hpp"
#include "core/rule.hpp"

namespace sunder::scene {

/// Reads one TOML table. Knows where it stands, so that every error is one sentence:
/// "FILE:LINE: TABLE: KEY must be …, not …". A key outside `known` is an error at once: before any
/// complaint that the key it was meant to be is missing.
///
/// The `read` functions leave `value` alone and return false when the key is absent. They throw
/// InputError when it holds something else than wanted. Refers to the TOML table, which must
/// outlive it.
class TableReader {
  public:
    using Keys = std::vector<std::string_view>;

    /// `what` names the whole file in messages: "the scene".
    TableReader(const toml::table& root, std::string file, std::string what, Keys known);

    bool has(std::string_view key) const { return table_->contains(key); }
    /// Throws unless the key is there. `hint` says what to give: "[x, y, z] in m".
    void require(std::string_view key, std::string_view hint) const;

    bool read(std::string_view key, bool& value) const;
    /// Whether it holds this text: a name for what is a number otherwise. Leaves what else it may
    /// hold to others, but for another text.
    bool holds(std::string_view key, std::string_view name) const;
    /// A whole number; 1e6 counts as one.
    bool read(std::string_view key, std::int64_t& value, const core::WholeRange& range) const;
    /// What a rule is about: a number, or a list of two or three. `single`: one number is taken for
    /// all three.
    template <class Struct>
    bool read(const core::Rule<Struct>& rule, Struct& object, bool single = false) const {
        core::Numbers numbers{{}, rule.count()};
        if (!readNumbers(rule.key, rule.range, rule.whole(), single, numbers)) return false;
        rule.set(object, numbers);
        return true;
    }
    /// The same for a whole table of rules.
    template <class Struct>
    void read(std::span<const core::Rule<Struct>> rules, Struct& object,
              bool single = false) const {
        for (const core::Rule<Struct>& rule : rules) read(rule, object, single);
    }
    /// One line of 1 to `maxCharacters` bytes without control characters.
    bool read(std::string_view key, std::string& value, std::size_t maxCharacters) const;

    /// Index of the key's value in `names`; none when the key is absent.
    std::optional<std::size_t> readChoice(std::string_view key,
                                          std::span<const std::string_view> names) const;
    /// The same for a list, in which each name may occur once.
    std::vector<std::size_t> readChoices(std::string_view key,
                                         std::span<const std::string_view> names) const;

    /// The table [key], if there is one.
    std::optional<TableReader> table(std::string_view key, Keys known) const;
    /// The tables [[key]], "key 1", "key 2", … in messages.
    std::vector<TableReader> tables(std::string_view key, const Keys& known,
                                    std::size_t maxCount) const;
    /// The tables [key.NAME], by name.
    std::vector<std::pair<std::string, TableReader>> namedTables(std::string_view key,
                                                                 const Keys& known,
                                                                 std::size_t maxCount) const;

    /// "FILE:LINE: TABLE", for later messages.
    std::string where() const;
    /// "FILE:LINE: TABLE: KEY", with the line of the key if it is there.
    std::string where(std::string_view key) const;

    /// Throws InputError "FILE:LINE: TABLE: `problem`", with the line of the key if it is there.
    [[noreturn]] void fail(std::string_view key, const std::string& problem) const;
    [[noreturn]] void fail(const std::string& problem) const { fail({}, problem); }
    /// The same for the checks that are not of files alone. Must not outlive the reader.
    core::Complain complain() const {
        return [this](std::string_view key, const std::string& problem) { fail(key, problem); };
    }

  private:
    TableReader(const TableReader& parent, const toml::table& table, std::string what, Keys known);
    void refuseUnknownKeys(const Keys& known) const;
    [[noreturn]] void failAt(const toml::node* node, const std::string& problem) const;
    std::string location(std::uint32_t line) const;
    /// Reads as many as `numbers` has.
    bool readNumbers(std::string_view key, const core::Range& range, bool whole, bool single,
                     core::Numbers& numbers) const;
    double number(const toml::node& node, const std::string& name, const core::Range& range,
                  bool whole) const;
    std::int64_t wholeNumber(const toml::node& node, const std::string& name,
                             const core::WholeRange& range) const;
    std::string line(const toml::node& node, const std::string& name,
                     std::size_t maxCharacters) const;
    const toml::array& list(const toml::node& node, std::string_view key, std::size_t size,
                            const std::string& kind) const;
    std::size_t choice(const toml::node& node, const std::string& name,
                       std::span<const std::string_view> names) const;

    const toml::table* table_;
    std::string file_;
    std::string what_;
    bool isRoot_;
};

}  // namespace sunder::scene
