#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "core/limits.hpp"
#include "core/rules.hpp"

namespace sunder::core {

// What a description must be beyond the tables of rules, written once for those who describe a
// world in a file and for those who do in code: a reader of files adds where it stands in the file.

/// Gets the key that is wrong and a sentence that names it: "radius must be …, not …". Throws
/// InputError, with the place before the sentence.
using Complain = std::function<void(std::string_view key, const std::string& problem)>;

/// Throws InputError: "THING: problem", or the problem alone where the thing has no name.
Complain complainAbout(const std::string& thing);

/// Throws InputError for the first thing that is wrong: a number outside its rule or not finite,
/// materials, bodies or objects that do not exist, regions outside their body, more of anything
/// than a world may have, names that are not one line or are another's, objects without contact.
/// The sentence begins with the thing: "body 'wall': ", "region 2 of body 'wall': ", "event 3: ".
/// Allocates nothing that grows with the cells.
void check(const WorldDescription&);

/// The numbers of `key`, each against its range, and a pair's order.
void checkNumbers(std::string_view key, const Range&, bool whole, const Numbers&, const Complain&);

template <class Struct>
void checkNumbers(const Rule<Struct>& rule, const Struct& object, const Complain& complain) {
    checkNumbers(rule.key, rule.range, rule.whole(), rule.get(object), complain);
}
template <class Struct>
void checkNumbers(std::span<const Rule<Struct>> rules, const Struct& object,
                  const Complain& complain) {
    for (const Rule<Struct>& rule : rules) checkNumbers(rule, object, complain);
}

/// Of a region whose numbers are in their ranges: whether it is in order and in a body of so many
/// cells.
void checkPlace(const RegionDescription&, const IVec3& cells, const Complain&);

/// What a fixed object, one on a chain and one that is not there at first may have. `given`:
/// whether a key was given.
void checkMotion(const ObjectDescription&, const std::function<bool(std::string_view)>& given,
                 const Complain&);

/// An event of a world with so many bodies.
void checkEvent(const EventDescription&, std::size_t bodies, const Complain&);

/// A throw of one of these objects.
void checkThrow(const ThrowDescription&, const std::vector<ObjectDescription>&, const Complain&);

/// Whether it can be thrown; the key is that of a throw.
void checkThrown(const ObjectDescription&, const Complain&);

/// Cells of some bodies of this size, or more than kMaxCells: never overflows. `cells` are in
/// their range, and copies at most 2³¹.
std::int64_t cellsOf(const IVec3& cells, std::int64_t copies = 1);

/// "there is already a body named 'wall'; every body needs a name of its own".
std::string nameTaken(std::string_view kind, std::string_view name);

/// "anchor names 'top' twice; once is enough".
std::string namedTwice(std::string_view key, std::string_view name);

}  // namespace sunder::core
