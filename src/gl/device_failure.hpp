#pragma once
#include "gl/functions.hpp"

#include <string>

namespace sunder::gl {

// What befalls a device: the same sentence and exit code wherever Sunder comes to know of it.

/// Whether the current context says that it is lost. A driver may say so only once.
bool contextLost();
/// Throws DeviceError (exit code 3): what the context holds is gone, and the input is not to
/// blame.
[[noreturn]] void failContextLost();
/// Throws InputError (exit code 2): less would have found room, as with a world beyond the device's
/// limits. One code for all: it is up to the driver whether it misses memory when it is asked for
/// it or when it first uses it. `what` found no room: "node state (120 MB)"; empty: not known.
[[noreturn]] void failMemory(const std::string& what = {});
/// Throws one of them where glGetError answered so.
void throwIfFatal(GLenum error);

}  // namespace sunder::gl
