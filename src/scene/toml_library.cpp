// What toml++ has beside its headers.

// toml++ 3.3 asserts, and to Clang in release builds promises, what a hostile file does not keep
// (`[[[`); without that its parser says what is wrong with the file. NDEBUG would bring the
// promise.
#undef NDEBUG
#define TOML_ASSERT(expression) static_assert(true)

#define TOML_IMPLEMENTATION
#include "scene/toml.hpp"
