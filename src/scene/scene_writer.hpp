#pragma once
#include <string>

#include "scene/scene.hpp"

namespace sunder::scene {

/// A material as a file of its own: parseMaterial() of it gives the same material, but for the
/// name, which is the file's.
std::string writeMaterial(const core::Material&);

/// A scene as a file that needs no other: `sunder run` of it ends in the same state, to the bit.
/// Copies of a body are bodies of their own in it.
std::string writeScene(const Scene&);

}  // namespace sunder::scene
