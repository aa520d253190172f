#pragma once
#include "gl/context.hpp"

/// The context all gpu tests of a process share. A test that cannot have one fails, with the
/// reason.
sunder::gl::Context& testContext();
