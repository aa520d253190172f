#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "window/context.hpp"

namespace sunder::window {

/// A device that a headless context may be made on.
struct HeadlessCandidate {
    int index;                ///< −1: has none
    std::string description;  ///< "EGL device 0 (EGL_MESA_device_software)"
    bool software;            ///< known to be, before a context was made
    /// Throws DeviceError: why not, without the description.
    std::function<std::unique_ptr<Context>(Profile)> open;
};

/// Every candidate, in the order of their index. Throws DeviceError when the platform's
/// window-system library itself is of no use. One implementation is compiled in: egl_context.cpp or
/// glfw_context.cpp (SUNDER_CONTEXT).
std::vector<HeadlessCandidate> headlessCandidates();

}  // namespace sunder::window
