#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace sunder::app {

/// A file that the user asked for.
struct Output {
    std::string option;          ///< such as --json
    std::filesystem::path path;  ///< empty: not asked for
};

/// Throws InputError now rather than after the work when one of them cannot be written, or when two
/// are the same file. Leaves nothing.
void checkOutputs(const std::vector<Output>&);

}  // namespace sunder::app
