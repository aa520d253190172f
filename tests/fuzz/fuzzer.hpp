#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "core/types.hpp"

/// One input: what libFuzzer calls, and fuzz/replay.cpp.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

inline std::string_view text(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// What a user is told is one line of readable length, whatever the input was.
inline void checkSentence(const sunder::core::InputError& error) {
    const std::string_view said = error.what();
    for (const char c : said)
        if (static_cast<unsigned char>(c) < 0x20) std::abort();
    if (said.size() < 10 || said.size() > 3000) std::abort();
}

/// Takes values from an input; zeros at its end.
class Input {
  public:
    Input(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
    bool any() const { return left_ > 0; }
    template <class Value>
    Value take() {
        Value value{};
        const std::size_t size = std::min(sizeof value, left_);
        if (size > 0) std::memcpy(&value, data_, size);
        data_ += size;
        left_ -= size;
        return value;
    }
    /// From a number of that many bytes.
    template <class Number = std::uint8_t>
    std::size_t below(std::size_t count) {
        return take<Number>() % count;
    }

  private:
    const std::uint8_t* data_;
    std::size_t left_;
};

}  // namespace fuzz
