#pragma once
#include "scene/table_reader.hpp"

namespace sunder::scene {

/// Reads `overlap` of a body or an object: whether it may be in something when the world begins
/// (core/overlap.hpp).
inline bool readOverlap(const TableReader& reader) {
    constexpr std::string_view choices[] = {"refuse", "allow"};
    return reader.readChoice("overlap", choices) == 1;
}

}  // namespace sunder::scene
