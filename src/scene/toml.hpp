#pragma once
// toml++, of which toml_library.cpp has what is beside its headers. Include this, never
// <toml++/toml.h> alone.
#define TOML_HEADER_ONLY 0
#include <toml++/toml.h>
