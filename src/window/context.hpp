#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/types.hpp"
#include "gl/driver.hpp"

namespace sunder::window {

enum class Profile {
    Core,
    Compatibility,  ///< as a host may have it; not every driver does
};

/// What `make(minor, told)` gives first that is not null: a context of OpenGL 4.3 for the solver
/// `compute`, else 4.1, which does for all else; told of a reset of the device, unless the driver
/// refuses to be asked. Null where there is none.
template <class Make>
auto newestContext(const Make& make) {
    auto made = make(3, true);
    for (const auto& [minor, told] : {std::pair(3, false), std::pair(1, true), std::pair(1, false)})
        if (!made) made = make(minor, told);
    return made;
}

/// A GL context of our own, 4.1 core unless asked for otherwise. Made current on the calling thread
/// where and when it is made; any other context is then not current there any more. Several may be
/// alive: on one thread, makeCurrent() says which is meant; several threads have one each.
///
/// A debug callback collects what the driver reports; see takeErrors(). There is no surface: bind a
/// complete framebuffer object before any draw, transform feedback under GL_RASTERIZER_DISCARD
/// included.
class Context {
  public:
    virtual ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    const gl::DeviceInfo& info() const { return info_; }
    gl::Driver& driver() { return *driver_; }
    /// On the calling thread, with its driver. It must be current on no other.
    void makeCurrent();
    /// Where its functions come from, as a host would hand it to a guest.
    virtual gl::Driver::LoadFunction loadFunction() const = 0;
    /// As Driver has it.
    std::vector<std::string> takeErrors() { return driver_->takeErrors(); }
    void check() { driver_->check(); }

  protected:
    Context() = default;
    /// Loads GL entry points, installs the debug callback. Throws DeviceError below GL 4.1.
    void initialise(std::string device);

  private:
    friend std::unique_ptr<Context> createHeadlessContext(Profile);
    virtual void bindContext() = 0;

    gl::DeviceInfo info_;
    std::optional<gl::Driver> driver_;
};

/// A context without a visible window: EGL devices, hardware before software, then
/// EGL_MESA_platform_surfaceless; a hidden GLFW window where there is no EGL. The environment
/// variable SUNDER_EGL_DEVICE (an index, `software`, or part of a name such as `nvidia`; empty
/// means not set) picks a device strictly. Throws DeviceError with one sentence that says what was
/// tried.
std::unique_ptr<Context> createHeadlessContext(Profile = Profile::Core);

/// One entry per device a headless context could try, whether or not it works.
struct DeviceListEntry {
    int index;                ///< what SUNDER_EGL_DEVICE takes; −1: has none
    std::string description;  ///< extensions or names that tell devices apart
    bool usable;
    gl::DeviceInfo info;  ///< when usable
    std::string problem;  ///< when not
};
/// In the order of their index. Makes a context on each: afterwards none is current on this thread.
std::vector<DeviceListEntry> listDevices();

}  // namespace sunder::window
