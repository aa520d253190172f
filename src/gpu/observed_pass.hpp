#pragma once
#include "core/solver.hpp"
#include "gpu/texel_target.hpp"

namespace sunder::gpu {

/// Tells the observer, if there is one, what a pass wrote. Waits for the GPU.
/// The first `count` texels of the first `layers`.
void observe(core::PassObserver* observer, const char* pass, const TexelTarget& wrote, int count,
             int layers);
/// The first `count` RGBA32F texels of a colour attachment, which is `width` wide.
void observe(core::PassObserver* observer, const char* pass, const gl::Framebuffer& wrote,
             int attachment, int width, int count);
/// A buffer of floats.
void observe(core::PassObserver* observer, const char* pass, const gl::Buffer& wrote);

}  // namespace sunder::gpu
