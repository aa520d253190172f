#pragma once
#include <memory>
#include <string_view>

#include "sim/solvers.hpp"

namespace sunder::sim {

/// Where a world of the public interface is simulated, other than on the CPU alone.
class Backend {
  public:
    virtual ~Backend() = default;

    /// Whoever uses what the device holds does so while one of these lives.
    class Stay {
      public:
        virtual ~Stay() = default;
    };
    enum class Work {
        Any,
        Deletes,  ///< only destructors
    };
    /// Throws InputError where a host is in the midst of something, DeviceError where the device
    /// is gone; never for work that only deletes.
    virtual std::unique_ptr<Stay> enter(Work = Work::Any) = 0;

    /// Puts a world there. Within a stay.
    virtual std::shared_ptr<const Layout> layOut(core::WorldDescription) = 0;
    /// Empty: the default. Throws InputError listing the known ones.
    virtual const SolverInfo& findSolver(std::string_view name) = 0;
    /// Throws what has gone wrong there meanwhile. Within a stay.
    virtual void check() = 0;
};

}  // namespace sunder::sim
