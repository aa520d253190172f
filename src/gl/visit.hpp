#pragma once
#include "gl/driver.hpp"

namespace sunder::gl {

/// A guest's stay in a GL context. Whoever calls solvers, or makes or destroys what lives in the
/// context, does so while one of these lives; the context is current on this thread all that time.
///
///     gl::Driver driver(getProcAddress, "the host's context", gl::Driver::Owner::Host);  // once
///     ...
///     const gl::Visit visit(driver);
///     solver.advance(steps);
///
/// A Visit within another of the same driver does nothing. To come and go costs, with the 33
/// textures that a solver binds, a median of 4 µs where the host has set little and 6 µs where it
/// has set everything (llvmpipe of Mesa 22.3; with NVIDIA's driver on an H200 16 and 28 µs), and
/// 1 µs (5 µs) with State::Dirty. `sunder_gpu_tests --visit-cost` measures it.
///
/// What GL does not let a guest put back, and a host has to see to:
/// - a query that counts samples, primitives or what transform feedback has written is refused with
///   an InputError; so is a program in use that has been deleted. One that measures time, or counts
///   what shaders do, goes on and includes Sunder;
/// - conditional rendering cannot be asked for: end it before. With Driver::askErrors() it is
///   noticed and refused;
/// - errors: see Driver::Owner;
/// - an object that was deleted in another context of the share group while it is bound in this one
///   is not bound any more afterwards;
/// - between glBegin and glEnd nothing can be called at all.
class Visit {
  public:
    /// What becomes of the state of a context during a Visit.
    enum class State {
        /// All of it is in the end as it was in the beginning.
        Restored,
        /// Nothing is asked and nothing put back: for hosts that set all state before they draw.
        /// Sunder sets what it depends on and leaves behind:
        /// - enabled: dithering and multisampling, as in a new context, and nothing else; all
        ///   colour masks are true;
        /// - bound: framebuffers, vertex array, program and buffers of its own, its textures and no
        ///   samplers on the units it uses, any unit active, any viewport; pixels are packed and
        ///   unpacked as in a new context, from and to no buffer.
        /// No transform feedback of the host's may be active.
        Dirty,
        /// The context is Sunder's own: only its functions become current.
        Ours,
    };

    enum class Work {
        Any,
        Deletes,  ///< nothing but deleting, as in destructors: nothing of the host's is in the way
    };

    /// Throws InputError when the host is in the midst of something that cannot be interrupted;
    /// then nothing has changed. Never where it only deletes. DeviceError when the context is gone
    /// and there is more to do than that.
    explicit Visit(Driver& driver, State state = State::Restored, Work work = Work::Any);
    ~Visit();
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;

  private:
    void enter();
    void refuseConditionalRendering() const;

    Driver& driver_;
    Driver* before_;
    State state_;
    Work work_;
    bool nested_;
};

}  // namespace sunder::gl
