#pragma once
#include <string>

#include "window/context.hpp"

/// One of this name, with this version of its driver.
inline sunder::gl::DeviceInfo device(const std::string& renderer, const std::string& version) {
    sunder::gl::DeviceInfo info;
    info.renderer = renderer;
    info.version = version;
    return info;
}
