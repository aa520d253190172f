// What toml++ has beside its headers.
#define TOML_IMPLEMENTATION
#include "scene/toml.hpp"
