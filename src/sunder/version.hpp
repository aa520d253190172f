#pragma once
#include <sunder/export.h>

/// The version of these headers, by semantic versioning: before 1.0 a new minor version may change
/// what compiled before; a new patch version does not.
#define SUNDER_VERSION_MAJOR 0
#define SUNDER_VERSION_MINOR 2  ///< Of these headers.
#define SUNDER_VERSION_PATCH 0  ///< Of these headers.

namespace sunder {

/// A version of the library.
struct Version {
    int major = 0;  ///< Changes when what compiled before may not compile any more.
    int minor = 0;  ///< Changes when something is added; before 1.0 it counts like `major`.
    int patch = 0;  ///< Changes when something is mended.
};

/// The version of the library that the program runs with, which may be newer than that of the
/// headers. From any thread.
SUNDER_API Version version() noexcept;

}  // namespace sunder
