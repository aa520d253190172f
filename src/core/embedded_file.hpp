#pragma once
#include <string_view>

namespace sunder::core {

/// A file that was compiled into the program (tools/cmake/embed.cmake).
struct EmbeddedFile {
    std::string_view name;  ///< path below the folder it was embedded from, '/' as separator
    std::string_view text;
};

}  // namespace sunder::core
