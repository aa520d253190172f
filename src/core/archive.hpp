#pragma once
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/state.hpp"

namespace sunder::core {

class World;

/// What a solver keeps between two steps, as bytes (core/saved_state.hpp). Each part of a solver
/// has one function `archive(Archive&)` that writes as well as reads, so that the two cannot drift
/// apart: it hands in what it has, and gets what it is to have, which is the same while writing.
/// Bytes are gone through twice, first by an archive that only checks: what is got is taken over
/// where reads(), and bytes that are refused have changed nothing.
///
/// Every number that comes from the bytes is compared with its range, and nothing is allocated for
/// which there are no bytes. Numbers are little-endian.
class Archive {
  public:
    /// Appends to `to`, which must outlive it.
    static Archive writing(std::vector<std::byte>& to) { return Archive(Mode::Write, &to, {}); }
    /// Throws InputError where `from` does not fit; must outlive it.
    static Archive checking(std::span<const std::byte> from) {
        return Archive(Mode::Check, nullptr, from);
    }
    static Archive reading(std::span<const std::byte> from) {
        return Archive(Mode::Read, nullptr, from);
    }

    bool writes() const { return mode_ == Mode::Write; }
    /// Whether what is got is to be taken over.
    bool reads() const { return mode_ == Mode::Read; }
    /// Nothing may be left of what is read.
    void end() const { require(writes() || from_.empty()); }

    /// What follows is that, in messages, and cannot be taken for anything else.
    void section(std::string_view what);
    /// Throws InputError unless what was read can be so.
    void require(bool fits) const {
        if (!fits) refuse();
    }

    /// Where the solver is in time, 0 to kLastStep.
    std::int64_t step(std::int64_t now) { return step_ = whole<std::int64_t>(now, 0, kLastStep); }
    /// What was got last.
    std::int64_t step() const { return step_; }
    static constexpr std::int64_t kLastStep = std::int64_t{1} << 53;

    template <std::integral Number>
    Number whole(Number now, Number low, Number high) {
        const Number got = raw(now);
        require(writes() || (got >= low && got <= high));
        return got;
    }
    /// Finite.
    template <std::floating_point Number>
    Number real(Number now, Number low = std::numeric_limits<Number>::lowest(),
                Number high = std::numeric_limits<Number>::max()) {
        const Number got = raw(now);
        require(writes() || (got >= low && got <= high));
        return got;
    }
    bool flag(bool now) { return whole<std::uint8_t>(now, 0, 1) != 0; }
    Vec3 vector(const Vec3& now) {
        return {real(now[0]), real(now[1]), real(now[2])};  // in this order: braces
    }
    /// All of them at once, finite. They are taken over where reads().
    template <std::floating_point Number>
    void reals(std::span<Number> numbers) {
        if (writes()) return put(std::as_bytes(numbers));
        const std::span<const std::byte> bytes = take(numbers.size_bytes());
        bool finite = true;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            Number number;
            std::memcpy(&number, bytes.data() + i * sizeof number, sizeof number);
            finite = finite && std::isfinite(number);
        }
        require(finite);
        if (reads() && !bytes.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
    }
    /// At most `most` items; each(item) archives one.
    template <class Item, class Each>
    void list(std::vector<Item>& items, std::size_t most, const Each& each) {
        const auto count = whole<std::uint64_t>(items.size(), 0, most);
        if (writes()) {
            for (Item& item : items) each(item);
            return;
        }
        items.clear();
        for (std::uint64_t i = 0; i < count; ++i) each(items.emplace_back());
    }

  private:
    enum class Mode { Write, Check, Read };
    Archive(Mode mode, std::vector<std::byte>* to, std::span<const std::byte> from)
        : mode_(mode), to_(to), from_(from) {}

    template <class Number>
    Number raw(Number now) {
        if (writes()) {
            put(std::as_bytes(std::span(&now, 1)));
        } else {
            std::memcpy(&now, take(sizeof now).data(), sizeof now);
        }
        return now;
    }
    void put(std::span<const std::byte> bytes) {
        to_->insert(to_->end(), bytes.begin(), bytes.end());
    }
    std::span<const std::byte> take(std::size_t count);
    [[noreturn]] void refuse() const;

    Mode mode_;
    std::vector<std::byte>* to_;
    std::span<const std::byte> from_;  ///< what is left
    std::string section_;
    std::int64_t step_ = 0;
};

/// Displacements, velocities, damage and slow parts of a state, as numbers of that type. What is
/// no bond is left as it is.
template <std::floating_point Number>
void archiveCells(Archive&, const World&, State&);
/// Which bodies are not there and whose anchors have let go, each ascending.
void archiveBodies(Archive&, const World&, std::vector<int>& absent, std::vector<int>& released);
/// Whether there are cells on both sides.
bool isBond(const World&, int bond);
/// The number of a bond.
int archiveBond(Archive&, const World&, int now);
/// Far more than a game makes.
inline constexpr std::size_t kMaxPushes = 1 << 20;
void archive(Archive&, const World&, Event&);
void archive(Archive&, ObjectState&);

}  // namespace sunder::core
