#pragma once
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gl/allocations.hpp"
#include "gl/device_info.hpp"
#include "gl/functions.hpp"
#include "gl/guest_state.hpp"
#include "gl/shader_assembly.hpp"
#include "gl/touched_bindings.hpp"

namespace sunder::gl {

/// One GL context as Sunder knows it: its functions, what it can do, what went wrong in it, what
/// Sunder has allocated there. It neither makes the context nor keeps it alive.
///
/// A driver is used by one thread at a time, the one its context is current on. Several drivers
/// may be used on one thread in turn and on several threads at once.
class Driver {
  public:
    /// The address of a GL function, as glfwGetProcAddress and its like return it; null: there is
    /// none.
    using LoadFunction = std::function<void (*(const char* name))()>;

    /// Who made the context, and so whose its errors and its debug output are.
    enum class Owner {
        Sunder,
        /// As a guest, Sunder leaves the debug callback alone and does not ask glGetError: GL keeps
        /// an error until somebody asks, there is no way to put it back, and a host that looks for
        /// its own would miss it. What Sunder's own calls raise stays there for the host to find.
        /// Memory that is missing for a buffer is noticed all the same; for a texture, see
        /// askErrors().
        Host,
    };

    /// Adopts the context that is current on the calling thread. Throws DeviceError where it is
    /// older than GL 4.1 or not OpenGL. `device`: DeviceInfo::device. GL calls go to it from
    /// makeCurrent() on, or for as long as a Visit lives.
    Driver(const LoadFunction& load, std::string device, Owner owner);
    ~Driver();
    Driver(const Driver&) = delete;
    Driver& operator=(const Driver&) = delete;

    /// The driver whose context this thread's GL calls go to; null: none.
    static Driver* current();
    /// From now on this thread's GL calls go to this driver's functions. Its context must be
    /// current. No GL call.
    void makeCurrent();
    /// This thread's GL calls go to `driver`'s functions, or to none.
    static void setCurrent(Driver* driver);

    Functions& functions() { return functions_; }
    const DeviceInfo& info() const { return info_; }
    Owner owner() const { return owner_; }

    /// For a host: whether Sunder asks glGetError when a Visit begins and ends and when it
    /// allocates. What the host had pending when a Visit began is then in takeHostErrors(), and
    /// lost to glGetError; in return, missing memory is noticed wherever it is missing, and so is
    /// conditional rendering that the host has left on. Off by default. A driver of Sunder's own
    /// context always asks.
    void askErrors(bool ask) { asks_ = ask || owner_ == Owner::Sunder; }
    bool asksErrors() const { return asks_; }
    /// GL errors and debug messages of high severity since the last call, oldest first; empties
    /// the list. Errors that Sunder turned into an exception where they happened (no memory for a
    /// buffer, a shader that does not compile) are not in it. Of a host's context, those it knows
    /// of without asking, unless askErrors(). Throws DeviceError once the context is lost
    /// (gl/device_failure.hpp). The context must be current.
    std::vector<std::string> takeErrors();
    /// Throws std::runtime_error with the first of takeErrors(), if any; InputError when the
    /// device's memory is exhausted.
    void check();

    /// A host has destroyed the context: its objects are gone, and a Visit only lets go of them.
    void contextGone() { gone_ = true; }
    bool isContextGone() const { return gone_; }

    /// What glGetError knew when a Visit began, since the last call: see askErrors().
    std::vector<std::string> takeHostErrors() { return std::exchange(hostErrors_, {}); }

    /// glPixelTransferf, which only the compatibility profile has.
    void setPixelTransfer(GLenum name, GLfloat value) const {
        if (pixelTransfer_) pixelTransfer_(name, value);
    }

    /// What Sunder has allocated there.
    Allocations buffers, textures;
    /// Where programs that name no source take their shaders from.
    ShaderSource shaders = embeddedShaders();
    /// The transform feedback object that is bound while nothing is captured: never one of a
    /// host's.
    GLuint idleFeedback = 0;
    /// What a Visit has to put back, beside the state that it saves when it begins.
    TouchedBindings touched;

  private:
    friend class Visit;
    void learn();
    void listen();
    void collect(const char* message, bool isError);
    /// Takes in what glGetError knows.
    void drain();
    /// What was there before a Visit: a host's errors are not Sunder's.
    void noteErrorsBefore();

    Functions functions_{};
    void(GLAD_API_PTR* pixelTransfer_)(GLenum, GLfloat) = nullptr;
    std::unique_ptr<GuestState> state_;  // once there has been a visit
    DeviceInfo info_;
    Owner owner_;
    bool asks_;
    std::vector<std::string> errors_, hostErrors_;
    bool errorReported_ = false;  // by the debug callback, since glGetError was last asked
    bool exhausted_ = false;      // the device's memory, since check() was last called
    bool lost_ = false;           // for good
    bool visited_ = false;
    bool gone_ = false;
};

}  // namespace sunder::gl
