#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/embedded_file.hpp"

namespace sunder::scene {

enum class PresetKind { Scene, Material };

/// The preset's file, or null.
const core::EmbeddedFile* findPreset(PresetKind kind, std::string_view name);

/// Sorted.
std::vector<std::string> presetNames(PresetKind kind);

}  // namespace sunder::scene
