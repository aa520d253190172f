#pragma once
#include "view/session.hpp"

namespace sunder::view {

/// `sunder view`: opens a window and returns when it is closed. Throws ContextError where there is
/// no screen, InputError for wrong use.
void view(const Options&);

}  // namespace sunder::view
