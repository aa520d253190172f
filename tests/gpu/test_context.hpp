#pragma once
#include "gl/context.hpp"

/// The context of the running test case, made when first asked for. A test that cannot have one
/// fails, with the reason.
sunder::gl::Context& testContext();
