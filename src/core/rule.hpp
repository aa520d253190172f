#pragma once
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>

#include "core/range.hpp"
#include "core/types.hpp"

namespace sunder::core {

/// What a rule is about: one number, a pair or three of a kind. None: an optional that is not set.
struct Numbers {
    std::array<double, 3> values{0, 0, 0};
    int count = 0;  ///< 0 to 3
};

/// A number that a struct does not hold as a file has it.
template <class Struct, class Value>
struct Property {
    Value (*get)(const Struct&);
    void (*set)(Struct&, const Value&);
};

/// One entry of a table of rules: what a number of a struct may be, and how to get at it.
template <class Struct>
struct Rule {
    /// A pair is [low, high], and low is less than high.
    using Field = std::variant<double Struct::*, int Struct::*, Vec3 Struct::*, IVec3 Struct::*,
                               std::array<double, 2> Struct::*, std::optional<double> Struct::*,
                               std::optional<Vec3> Struct::*, Property<Struct, double>,
                               Property<Struct, Vec3>>;

    std::string_view key;  ///< as in a file, for example "young_modulus"
    Range range;           ///< of each of its numbers
    Field field;
    std::string_view help;  ///< one or two sentences: what it is, what raising it does

    /// 1, 2 or 3: how many numbers it has where it is set.
    int count() const;
    /// Whether its numbers are whole.
    bool whole() const;
    Numbers get(const Struct&) const;
    /// Takes as many numbers as count() says.
    void set(Struct&, const Numbers&) const;
};

/// The rule with this key; null: there is none.
template <class Struct>
const Rule<Struct>* findRule(std::span<const Rule<Struct>> rules, std::string_view key) {
    for (const Rule<Struct>& rule : rules)
        if (rule.key == key) return &rule;
    return nullptr;
}

// --- The members of Rule ---

namespace rule_detail {

template <class Value>
inline constexpr int kCount = 1;
template <>
inline constexpr int kCount<Vec3> = 3;
template <>
inline constexpr int kCount<IVec3> = 3;
template <>
inline constexpr int kCount<std::array<double, 2>> = 2;
template <>
inline constexpr int kCount<std::optional<Vec3>> = 3;

template <class Struct, class Value>
constexpr int countOf(Value Struct::*) {
    return kCount<Value>;
}
template <class Struct, class Value>
constexpr int countOf(const Property<Struct, Value>&) {
    return kCount<Value>;
}

inline Numbers numbers(double value) {
    return {{value, 0, 0}, 1};
}
inline Numbers numbers(const Vec3& value) {
    return {{value[0], value[1], value[2]}, 3};
}
inline Numbers numbers(const IVec3& value) {
    return numbers(Vec3(value.cast<double>()));
}
inline Numbers numbers(const std::array<double, 2>& value) {
    return {{value[0], value[1], 0}, 2};
}
template <class Value>
Numbers numbers(const std::optional<Value>& value) {
    return value ? numbers(*value) : Numbers{};
}

inline void assign(double& value, const Numbers& n) {
    value = n.values[0];
}
inline void assign(int& value, const Numbers& n) {
    value = static_cast<int>(n.values[0]);
}
inline void assign(Vec3& value, const Numbers& n) {
    value = {n.values[0], n.values[1], n.values[2]};
}
inline void assign(IVec3& value, const Numbers& n) {
    value = Vec3(n.values[0], n.values[1], n.values[2]).cast<int>();
}
inline void assign(std::array<double, 2>& value, const Numbers& n) {
    value = {n.values[0], n.values[1]};
}
template <class Value>
void assign(std::optional<Value>& value, const Numbers& n) {
    assign(value.emplace(), n);
}

}  // namespace rule_detail

template <class Struct>
int Rule<Struct>::count() const {
    return std::visit([](const auto& f) { return rule_detail::countOf(f); }, field);
}

template <class Struct>
bool Rule<Struct>::whole() const {
    return std::holds_alternative<int Struct::*>(field) ||
           std::holds_alternative<IVec3 Struct::*>(field);
}

template <class Struct>
Numbers Rule<Struct>::get(const Struct& object) const {
    return std::visit(
        [&](const auto& f) {
            if constexpr (std::is_member_pointer_v<std::remove_cvref_t<decltype(f)>>)
                return rule_detail::numbers(object.*f);
            else
                return rule_detail::numbers(f.get(object));
        },
        field);
}

template <class Struct>
void Rule<Struct>::set(Struct& object, const Numbers& n) const {
    std::visit(
        [&](const auto& f) {
            if constexpr (std::is_member_pointer_v<std::remove_cvref_t<decltype(f)>>) {
                rule_detail::assign(object.*f, n);
            } else {
                auto value = f.get(object);
                rule_detail::assign(value, n);
                f.set(object, value);
            }
        },
        field);
}

}  // namespace sunder::core
