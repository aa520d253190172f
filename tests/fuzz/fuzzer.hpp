#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdlib>
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

}  // namespace fuzz
