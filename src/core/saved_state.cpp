#include "core/saved_state.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/archive.hpp"
#include "core/fnv.hpp"

namespace sunder::core {
namespace {

constexpr std::size_t kMagicSize = sizeof kStateMagic - 1, kNameSize = 12;
constexpr std::size_t kChecksumSize = sizeof(std::uint64_t);
constexpr std::size_t kLengthAt = kMagicSize + sizeof(std::uint32_t) + kNameSize + 8;
constexpr std::size_t kHeaderSize = kLengthAt + sizeof(std::uint64_t);

using Name = std::array<char, kNameSize>;

Name nameOf(const Solver& solver) {
    Name name{};
    solver.name().copy(name.data(), name.size());
    return name;
}

template <class Value>
void append(std::vector<std::byte>& bytes, const Value& value) {
    const auto added = std::as_bytes(std::span(&value, 1));
    bytes.insert(bytes.end(), added.begin(), added.end());
}

/// The next value of the header.
template <class Value>
Value next(std::span<const std::byte>& bytes) {
    Value value;
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes = bytes.subspan(sizeof value);
    return value;
}

[[noreturn]] void refuse(const std::string& why) {
    throw InputError("the saved state cannot be restored: " + why);
}

/// A name that may be shown, or nothing.
std::string shown(const Name& name) {
    const auto end = std::find(name.begin(), name.end(), '\0');
    const bool plain = std::all_of(name.begin(), end, [](char c) { return c >= 'a' && c <= 'z'; });
    return plain ? std::string(name.begin(), end) : std::string();
}

/// What the solver's parts are to read.
std::span<const std::byte> contentsOf(const World& world, const Solver& solver,
                                      std::span<const std::byte> bytes) {
    if (bytes.size() < kMagicSize || std::memcmp(bytes.data(), kStateMagic, kMagicSize) != 0)
        refuse(
            "it does not begin as a state that Sunder saved does; restore what saveState() gave");
    if (bytes.size() < kHeaderSize + kChecksumSize)
        refuse("it has only " + std::to_string(bytes.size()) +
               " bytes; restore all that saveState() gave");
    std::span<const std::byte> header = bytes.subspan(kMagicSize);
    if (const auto format = next<std::uint32_t>(header); format != kStateFormat)
        refuse("its format has number " + std::to_string(format) +
               ", this version of Sunder reads " + std::to_string(kStateFormat) +
               "; save it with this version");
    const auto name = next<Name>(header);
    const auto fingerprint = next<std::uint64_t>(header), length = next<std::uint64_t>(header);
    if (length != bytes.size())
        refuse("it has " + std::to_string(bytes.size()) + " bytes instead of " +
               std::to_string(length) + "; restore all that saveState() gave");
    std::span<const std::byte> last = bytes.last(kChecksumSize);
    if (next<std::uint64_t>(last) != stateChecksum(bytes))
        refuse("its checksum is wrong, so it was changed since; restore what saveState() gave");
    if (name != nameOf(solver))
        refuse("it is of the solver '" + shown(name) + "', not of '" + std::string(solver.name()) +
               "'; restore it with the solver that saved it");
    if (fingerprint != world.fingerprint())
        refuse("it is of another world; restore it in one of the same description");
    return header.first(header.size() - kChecksumSize);
}

void archive(Archive& a, const World& world, Solver& solver, std::vector<PresenceChange>& changes) {
    solver.archive(a);
    a.section("bodies that come or go");
    const auto bodies = static_cast<int>(world.bodies().size());
    // Each comes and goes once at most.
    a.list(changes, 2 * world.bodies().size(), [&](PresenceChange& change) {
        change.body = a.whole(change.body, 0, bodies - 1);
        change.present = a.flag(change.present);
        change.released = a.flag(change.released);
    });
}

}  // namespace

std::uint64_t stateChecksum(std::span<const std::byte> bytes) {
    Fnv1a hash;
    hash.add(bytes.first(bytes.size() - kChecksumSize));
    return hash.value();
}

std::vector<std::byte> saveState(const World& world, Solver& solver,
                                 std::vector<PresenceChange> changes) {
    solver.finish();
    std::vector<std::byte> bytes;
    // About what nodes and bonds take, so that it seldom moves.
    bytes.reserve(kHeaderSize + kChecksumSize + 256 * static_cast<std::size_t>(world.cellCount()));
    bytes.resize(kMagicSize);
    std::memcpy(bytes.data(), kStateMagic, kMagicSize);
    append(bytes, kStateFormat);
    append(bytes, nameOf(solver));
    append(bytes, world.fingerprint());
    append(bytes, std::uint64_t{0});
    Archive writing = Archive::writing(bytes);
    archive(writing, world, solver, changes);
    const std::uint64_t length = bytes.size() + kChecksumSize;
    std::memcpy(bytes.data() + kLengthAt, &length, sizeof length);
    append(bytes, std::uint64_t{0});
    const std::uint64_t checksum = stateChecksum(bytes);
    std::memcpy(bytes.data() + bytes.size() - kChecksumSize, &checksum, kChecksumSize);
    return bytes;
}

std::int64_t restoreState(const World& world, Solver& solver, std::span<const std::byte> bytes,
                          std::vector<PresenceChange>& changes) {
    const std::span<const std::byte> contents = contentsOf(world, solver, bytes);
    std::vector<PresenceChange> got;
    Archive checking = Archive::checking(contents);
    archive(checking, world, solver, got);
    checking.end();
    Archive reading = Archive::reading(contents);
    archive(reading, world, solver, got);
    changes = std::move(got);
    return reading.step();
}

std::int64_t restoreState(const World& world, Solver& solver, std::span<const std::byte> bytes) {
    std::vector<PresenceChange> changes;
    return restoreState(world, solver, bytes, changes);
}

}  // namespace sunder::core
