// What toml++ is beside its headers.
#define TOML_IMPLEMENTATION
#include <toml++/toml.h>
