#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace sunder::gl {

/// What the driver says of itself, and the limits Sunder runs into.
struct DeviceInfo {
    std::string vendor, renderer, version, glslVersion;
    /// How it was found: "EGL device 1 (EGL_MESA_device_software)", "EGL surfaceless", "hidden
    /// window".
    std::string device;
    bool software = false;
    int maxTextureSize = 0;
    int maxTextureBufferSize = 0;            ///< texels
    int maxUniformBlockSize = 0;             ///< bytes
    int maxTransformFeedbackComponents = 0;  ///< interleaved
    int maxGeometryOutputComponents = 0;     ///< total
    int maxSamples = 0;
    /// Devices that were preferred to this one but did not work: "EGL device 0 (…): why".
    std::vector<std::string> skipped;
};

/// Whether a driver that calls itself `renderer` (GL_RENDERER) draws on the CPU.
bool isSoftware(const std::string& renderer);

/// A GL 4.1 core context, made current on the calling thread while it lives. One at a time.
///
/// A debug callback collects what the driver reports; see takeErrors(). There is no surface: bind a
/// complete framebuffer object before any draw, transform feedback under GL_RASTERIZER_DISCARD
/// included.
class Context {
  public:
    virtual ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    const DeviceInfo& info() const { return info_; }
    /// GL errors and debug messages of high severity since the last call, oldest first; empties the
    /// list. Errors that Sunder turned into an exception where they happened (no memory for a
    /// buffer, a shader that does not compile) are not in it. Throws ContextError once the context
    /// is lost (gl/device_failure.hpp).
    std::vector<std::string> takeErrors();
    /// Throws std::runtime_error with the first of takeErrors(), if any; InputError when the
    /// device's memory is exhausted.
    void check();

  protected:
    Context() = default;
    using LoadFunction = void (*(*)(const char*))();
    /// Loads GL entry points, fills info_, installs the debug callback. Throws ContextError below
    /// GL 4.1.
    void initialise(LoadFunction load, std::string device);

  private:
    friend std::unique_ptr<Context> createHeadlessContext();
    void collect(const char* message, bool isError);

    DeviceInfo info_;
    std::vector<std::string> errors_;
    bool errorReported_ = false;  // by the debug callback, since glGetError was last asked
    bool exhausted_ = false;      // the device's memory, since check() was last called
    bool lost_ = false;           // for good
};

/// A context without a visible window: EGL devices, hardware before software, then
/// EGL_MESA_platform_surfaceless; a hidden GLFW window where there is no EGL. The environment
/// variable SUNDER_EGL_DEVICE (an index, `software`, or part of a name such as `nvidia`; empty
/// means not set) picks a device strictly. Throws ContextError with one sentence that says what was
/// tried.
std::unique_ptr<Context> createHeadlessContext();

/// One entry per device a headless context could try, whether or not it works.
struct DeviceListEntry {
    int index;                ///< what SUNDER_EGL_DEVICE takes; −1: has none
    std::string description;  ///< extensions or names that tell devices apart
    bool usable;
    DeviceInfo info;      ///< when usable
    std::string problem;  ///< when not
};
/// In the order of their index. Makes a context on each; no other Context may be alive.
std::vector<DeviceListEntry> listDevices();

}  // namespace sunder::gl
