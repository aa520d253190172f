#pragma once
#include "view/session.hpp"

namespace sunder::view {

/// `sunder view`: opens a window and returns when it is closed: 0, or the signal that closed it.
/// Throws DeviceError where there is no screen, InputError for wrong use.
int view(const Options&);

}  // namespace sunder::view
