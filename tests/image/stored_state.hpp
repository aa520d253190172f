#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "core/world.hpp"

/// A stored state that cannot be drawn: missing, damaged, of another world. Names the file.
struct StateError : sunder::core::InputError {
    using InputError::InputError;
};

/// What a picture shows of a state: displacements, which bonds are broken, where objects are, all
/// in the single precision that drawing has. Stored, so that a picture moves when drawing changes
/// and not when the physics does.
std::string encodeState(const sunder::core::State&);

/// Velocities, slow tractions and how far an unbroken bond is damaged are not stored: they are
/// those of the world at rest. Throws StateError. `name` is the file's in messages.
sunder::core::State decodeState(std::string_view bytes, const sunder::core::World&,
                                const std::string& name);

void writeState(const std::filesystem::path&, const sunder::core::State&);
/// Throws StateError.
sunder::core::State readState(const std::filesystem::path&, const sunder::core::World&);
