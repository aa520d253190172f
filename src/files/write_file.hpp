#pragma once
#include <filesystem>
#include <string_view>

namespace sunder::files {

/// Every file that is written whole is written by this: under a temporary name in the same folder,
/// then renamed, so that nothing half-written ever stands under `path`. Follows a link; writes to a
/// device or pipe straight away. Throws InputError naming path and reason; then `path` is as it was
/// and no other file is left.
void writeFile(const std::filesystem::path& path, std::string_view bytes);

/// The same, unless there is such a file: then false, and it is as it was. However many do this at
/// once, one of them writes it.
bool writeNewFile(const std::filesystem::path& path, std::string_view bytes);

/// The same under FOLDER/NAME-001.png where `path` is FOLDER/NAME.png, or under the first number
/// that nothing has yet; returns it.
std::filesystem::path writeNumberedFile(const std::filesystem::path& path, std::string_view bytes);

/// Throws now what writeFile() would throw because of where `path` lies: it makes the temporary
/// file and removes it again. To be called before the work whose result goes there. An empty path
/// is none.
void checkWritable(const std::filesystem::path& path);

}  // namespace sunder::files
