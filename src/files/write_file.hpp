#pragma once
#include <filesystem>
#include <string_view>

namespace sunder {

/// Every file that is written whole is written by this: under a temporary name in the same folder,
/// then renamed, so that nothing half-written ever stands under `path`. Follows a link; writes to a
/// device or pipe straight away. Throws InputError naming path and reason; then `path` is as it was
/// and no other file is left.
void writeFile(const std::filesystem::path& path, std::string_view bytes);

}  // namespace sunder
