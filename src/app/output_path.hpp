#pragma once
#include <filesystem>

namespace sunder::app {

/// Throws InputError now rather than after the work when `path` cannot be written; the folder `out`
/// is made later. An empty path is none.
void checkWritable(const std::filesystem::path& path, const std::filesystem::path& out = {});

}  // namespace sunder::app
