#pragma once
#include <optional>

#include "gl/visit.hpp"
#include "sim/backend.hpp"
#include "sunder/gl.hpp"

namespace sunder::gl {

/// What a Device is inside: the host's context as Sunder knows it, and worlds made there.
struct Device::Impl : sim::Backend {
    explicit Impl(DeviceOptions chosen) : options(std::move(chosen)) {}

    std::unique_ptr<Stay> enter(Work = Work::Any) override;
    std::shared_ptr<const sim::Layout> layOut(core::WorldDescription) override;
    const sim::SolverInfo& findSolver(std::string_view name) override;
    void check() override;

    DeviceOptions options;
    std::optional<Driver> driver;  ///< none where it could not be made
    Error error;
};

}  // namespace sunder::gl
