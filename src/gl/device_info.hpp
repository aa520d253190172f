#pragma once
#include <string>
#include <vector>

namespace sunder::gl {

/// What a driver says of itself, and the limits Sunder runs into.
struct DeviceInfo {
    std::string vendor, renderer, version, glslVersion;
    /// How it was found: "EGL device 1 (EGL_MESA_device_software)", "EGL surfaceless", "hidden
    /// window".
    std::string device;
    bool software = false;
    bool compatibility = false;  ///< the context has what GL 3.2 core has removed
    int maxTextureSize = 0;
    int maxTextureBufferSize = 0;            ///< texels
    int maxUniformBlockSize = 0;             ///< bytes
    int maxTransformFeedbackComponents = 0;  ///< interleaved
    int maxGeometryOutputComponents = 0;     ///< total
    int maxSamples = 0;
    int maxDrawBuffers = 0;
    int maxViewports = 0;
    /// Devices that were preferred to this one but did not work: "EGL device 0 (…): why".
    std::vector<std::string> skipped;
};

/// Whether a driver that calls itself `renderer` (GL_RENDERER) draws on the CPU.
bool isSoftware(const std::string& renderer);

}  // namespace sunder::gl
