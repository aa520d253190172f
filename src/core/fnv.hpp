#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace sunder::core {

/// 64-bit FNV-1a.
class Fnv1a {
  public:
    void add(std::span<const std::byte> bytes) {
        for (const std::byte byte : bytes)
            hash_ = (hash_ ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3u;
    }
    /// The bytes of a number as they lie in memory.
    template <class Number>
    requires std::is_arithmetic_v<Number>
    void add(Number number) { add(std::as_bytes(std::span(&number, 1))); }
    std::uint64_t value() const { return hash_; }

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace sunder::core
