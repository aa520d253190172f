// Headless contexts through EGL: no display server, no surface. The only file that knows EGL.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "window/headless_context.hpp"

#ifndef EGL_RENDERER_EXT  // EGL_EXT_device_query_name, missing in older headers
#define EGL_RENDERER_EXT 0x335F
#endif

namespace sunder::window {

using namespace core;

namespace {

std::string errorText() {
    switch (const EGLint error = eglGetError()) {
        case EGL_NOT_INITIALIZED:
            return "EGL_NOT_INITIALIZED";
        case EGL_BAD_ACCESS:
            return "EGL_BAD_ACCESS";
        case EGL_BAD_ALLOC:
            return "EGL_BAD_ALLOC";
        case EGL_BAD_ATTRIBUTE:
            return "EGL_BAD_ATTRIBUTE";
        case EGL_BAD_CONFIG:
            return "EGL_BAD_CONFIG";
        case EGL_BAD_DISPLAY:
            return "EGL_BAD_DISPLAY";
        case EGL_BAD_MATCH:
            return "EGL_BAD_MATCH";
        case EGL_BAD_PARAMETER:
            return "EGL_BAD_PARAMETER";
        default:
            return "EGL error " + std::to_string(error);
    }
}

[[noreturn]] void fail(const char* call) {
    throw DeviceError(std::string(call) + " failed: " + errorText());
}

bool hasExtension(const char* extensions, const std::string& name) {
    std::istringstream words(extensions ? extensions : "");
    for (std::string word; words >> word;)
        if (word == name) return true;
    return false;
}

template <class Function>
Function entryPoint(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// An initialised display. EGL keeps one per device for the whole process and does not count its
/// users: eglTerminate waits for the last of ours.
class Display {
  public:
    Display(EGLenum platform, void* device) {
        const auto getPlatformDisplay =
            entryPoint<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
        if (!getPlatformDisplay) throw DeviceError("EGL lacks eglGetPlatformDisplayEXT");
        id_ = getPlatformDisplay(platform, device, nullptr);
        if (id_ == EGL_NO_DISPLAY) fail("eglGetPlatformDisplayEXT");
        const std::lock_guard lock(mutex());
        EGLint major = 0, minor = 0;
        if (!eglInitialize(id_, &major, &minor)) fail("eglInitialize");
        ++users()[id_];
        version_ = {major, minor};
    }
    ~Display() {
        const std::lock_guard lock(mutex());
        if (--users()[id_] == 0) eglTerminate(id_);
    }
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    EGLDisplay id() const { return id_; }
    std::pair<int, int> version() const { return version_; }
    bool has(const char* extension) const {
        return hasExtension(eglQueryString(id_, EGL_EXTENSIONS), extension);
    }

  private:
    static std::mutex& mutex() {
        static std::mutex instance;
        return instance;
    }
    static std::map<EGLDisplay, int>& users() {
        static std::map<EGLDisplay, int> instance;
        return instance;
    }
    EGLDisplay id_;
    std::pair<int, int> version_;
};

EGLConfig anyConfig(const Display& display) {
    if (display.has("EGL_KHR_no_config_context") || display.has("EGL_MESA_configless_context"))
        return EGL_NO_CONFIG_KHR;
    // Surfaces of type 0: the default asks for windows, which a device without a display has not.
    const EGLint attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                 EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display.id(), attributes, &config, 1, &count)) fail("eglChooseConfig");
    if (count == 0) throw DeviceError("no EGL config renders OpenGL");
    return config;
}

/// `told`: of a reset of the device, which then loses the context. Unasked, a driver may go on with
/// pictures of nothing; some refuse to be asked.
EGLContext makeContext(const Display& display, EGLConfig config, Profile profile, EGLint major,
                       EGLint minor, bool debug, bool told) {
    const EGLint profileBit = profile == Profile::Core
                                  ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
                                  : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT;
    std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION,       major,
                                   EGL_CONTEXT_MINOR_VERSION,       minor,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK, profileBit,
                                   EGL_CONTEXT_OPENGL_DEBUG,        debug ? EGL_TRUE : EGL_FALSE};
    if (told)
        attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                             EGL_LOSE_CONTEXT_ON_RESET});
    attributes.push_back(EGL_NONE);
    return eglCreateContext(display.id(), config, EGL_NO_CONTEXT, attributes.data());
}

/// A context, current where it was made.
class OwnedContext {
  public:
    OwnedContext(const Display& display, Profile profile) : display_(display.id()) {
        const auto version = display.version();
        if (version < std::pair(1, 5))
            throw DeviceError("the driver offers EGL " + std::to_string(version.first) + "." +
                              std::to_string(version.second) + ", Sunder needs 1.5");
        if (!display.has("EGL_KHR_surfaceless_context"))
            throw DeviceError("the driver lacks EGL_KHR_surfaceless_context");
        if (!eglBindAPI(EGL_OPENGL_API)) fail("eglBindAPI(EGL_OPENGL_API)");
        const EGLConfig config = anyConfig(display);
        id_ = newestContext([&](EGLint minor, bool told) {
            return makeContext(display, config, profile, 4, minor, true, told);
        });
        // An older context is made only so that Context::initialise() can say which version there
        // is.
        if (id_ == EGL_NO_CONTEXT) {
            const std::string problem = errorText();
            id_ = makeContext(display, config, profile, 3, 2, false, false);
            if (id_ == EGL_NO_CONTEXT)
                throw DeviceError("eglCreateContext for OpenGL 4.1 core failed: " + problem);
        }
        try {
            makeCurrent();
        } catch (...) {
            eglDestroyContext(display_, id_);
            throw;
        }
    }
    ~OwnedContext() {
        if (eglGetCurrentContext() == id_)
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, id_);
    }
    OwnedContext(const OwnedContext&) = delete;
    OwnedContext& operator=(const OwnedContext&) = delete;

    void makeCurrent() {
        // The API is chosen per thread.
        if (!eglBindAPI(EGL_OPENGL_API)) fail("eglBindAPI(EGL_OPENGL_API)");
        if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, id_))
            fail("eglMakeCurrent without a surface");
    }

  private:
    EGLDisplay display_;
    EGLContext id_;
};

class EglContext final : public Context {
  public:
    EglContext(EGLenum platform, void* device, const std::string& description, Profile profile)
        : display_(platform, device), context_(display_, profile) {
        initialise(description);
    }
    gl::Driver::LoadFunction loadFunction() const override { return eglGetProcAddress; }

  private:
    void bindContext() override { context_.makeCurrent(); }

    // In this order: the context goes first, also when initialise() throws.
    Display display_;
    OwnedContext context_;
};

HeadlessCandidate candidate(int index, std::string description, bool software, EGLenum platform,
                            void* device) {
    auto open = [=](Profile profile) -> std::unique_ptr<Context> {
        return std::make_unique<EglContext>(platform, device, description, profile);
    };
    return {index, description, software, std::move(open)};
}

/// What tells a device from its neighbours: its file, its names, and else its extensions.
std::string describe(int index, EGLDeviceEXT device, const char* extensions,
                     PFNEGLQUERYDEVICESTRINGEXTPROC queryString) {
    std::string details;
    const auto add = [&](const char* value) {
        if (value && *value) details += (details.empty() ? "" : ", ") + std::string(value);
    };
    if (hasExtension(extensions, "EGL_EXT_device_query_name")) {
        add(queryString(device, EGL_VENDOR));
        add(queryString(device, EGL_RENDERER_EXT));
    }
    if (hasExtension(extensions, "EGL_EXT_device_drm"))
        add(queryString(device, EGL_DRM_DEVICE_FILE_EXT));
    add(extensions);
    return "EGL device " + std::to_string(index) + (details.empty() ? "" : " (" + details + ")");
}

std::vector<EGLDeviceEXT> queryDevices(const char* clientExtensions) {
    const bool enumerates = hasExtension(clientExtensions, "EGL_EXT_device_base") ||
                            hasExtension(clientExtensions, "EGL_EXT_device_enumeration");
    const auto query = entryPoint<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    EGLint count = 0;
    if (!enumerates || !query || !query(0, nullptr, &count) || count <= 0) return {};
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    if (!query(count, devices.data(), &count)) return {};
    devices.resize(static_cast<std::size_t>(std::max(count, 0)));
    return devices;
}

}  // namespace

std::vector<HeadlessCandidate> headlessCandidates() {
    const char* clientExtensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!clientExtensions)
        throw DeviceError(
            "EGL has no client extensions, so no device can be opened without a display");

    std::vector<HeadlessCandidate> candidates;
    const auto queryString = entryPoint<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    if (hasExtension(clientExtensions, "EGL_EXT_platform_device") && queryString) {
        for (EGLDeviceEXT device : queryDevices(clientExtensions)) {
            const char* extensions = queryString(device, EGL_EXTENSIONS);
            const int index = static_cast<int>(candidates.size());
            candidates.push_back(candidate(index, describe(index, device, extensions, queryString),
                                           hasExtension(extensions, "EGL_MESA_device_software"),
                                           EGL_PLATFORM_DEVICE_EXT, device));
        }
    }
    if (hasExtension(clientExtensions, "EGL_MESA_platform_surfaceless"))
        candidates.push_back(
            candidate(-1, "EGL surfaceless", false, EGL_PLATFORM_SURFACELESS_MESA, nullptr));
    return candidates;
}

}  // namespace sunder::window
