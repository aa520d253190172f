#include "sunder/gl_device.hpp"

#include "sim_gl/gl_layout.hpp"
#include "sim_gl/solvers.hpp"
#include "sunder/guard.hpp"

namespace sunder::gl {

namespace {

class VisitStay : public sim::Backend::Stay {
  public:
    VisitStay(Driver& driver, Visit::State state, Visit::Work work) : visit_(driver, state, work) {}

  private:
    Visit visit_;
};

}  // namespace

std::unique_ptr<sim::Backend::Stay> Device::Impl::enter(Work work) {
    return std::make_unique<VisitStay>(
        *driver, options.state == State::Dirty ? Visit::State::Dirty : Visit::State::Restored,
        work == Work::Deletes ? Visit::Work::Deletes : Visit::Work::Any);
}

std::shared_ptr<const sim::Layout> Device::Impl::layOut(core::WorldDescription description) {
    auto layout = std::make_shared<sim_gl::GlLayout>(std::move(description));
    layout->upload();
    return layout;
}

const sim::SolverInfo& Device::Impl::findSolver(std::string_view name) {
    return name.empty() ? sim_gl::solvers().front() : sim_gl::findSolver(name, "solver");
}

void Device::Impl::check() {
    if (options.log)
        for (const std::string& message : driver->takeHostErrors())
            options.log("an error of the host's own: " + message);
    driver->check();
}

Device::Device(DeviceOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {
    try {
        const GetProcAddress& find = impl_->options.getProcAddress;
        if (!find) throw core::InputError("a device needs getProcAddress, to find GL's functions");
        impl_->driver.emplace([find](const char* name) { return find(name); }, "the host's context",
                              Driver::Owner::Host);
        impl_->driver->askErrors(impl_->options.askErrors);
    } catch (...) {
        impl_->error = currentError();
    }
}

Device::~Device() = default;

bool Device::ok() const {
    return impl_->driver.has_value();
}

const Error& Device::error() const {
    return impl_->error;
}

std::string_view Device::renderer() const {
    return ok() ? std::string_view(impl_->driver->info().renderer) : std::string_view();
}

std::size_t Device::memory() const {
    return ok() ? impl_->driver->buffers.total() + impl_->driver->textures.total() : 0;
}

void Device::contextGone() {
    if (ok()) impl_->driver->contextGone();
}

Result<sim::Backend*> Device::backend() {
    if (!ok()) return error();
    return static_cast<sim::Backend*>(impl_.get());
}

}  // namespace sunder::gl
