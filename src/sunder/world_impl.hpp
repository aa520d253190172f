#pragma once
#include <optional>
#include <vector>

#include "sim/backend.hpp"
#include "sim/simulation.hpp"
#include "sunder/sunder.hpp"
#include "surface/picker.hpp"

namespace sunder {

/// What a World is inside: a simulation, and what the public interface adds to it.
struct World::Impl {
    Impl(const WorldDesc& description, const WorldOptions& options, sim::Backend* backend);
    ~Impl();

    const core::World& world() const { return simulation->world(); }
    /// As long as it lives, the device may be used; null: there is none.
    std::unique_ptr<sim::Backend::Stay> enter() const {
        return backend ? backend->enter() : nullptr;
    }
    /// Throws InputError. `what`: for whom.
    void checkObject(int object, const char* what) const;
    /// Likewise.
    void checkBody(int body, const char* what) const;
    /// Throws InputError where that would change nothing. `what`: for whom.
    Result<void> setPresent(int body, bool present, const char* what);
    std::shared_ptr<const sim::Layout> layOut(core::WorldDescription inner) const;
    /// Throws InputError, and then nothing has changed.
    void extend(const WorldDesc& description);
    void finishIncidents(const std::vector<core::Incident>& found);
    /// Runs `work` within a stay. A device that has failed once fails always.
    template <class Work>
    auto within(const Work& work) -> decltype(work());

    sim::Backend* backend;
    std::shared_ptr<const sim::Layout> layout;
    std::optional<sim::Simulation> simulation;
    std::string solver;
    double rest = 0;  ///< s, that no substep has taken up yet
    std::vector<Incident> incidents;
    std::vector<std::string> startNotes;
    int growths = 0;               ///< calls of extend() that worked
    double growthSeconds = 0;      ///< how long the last one took
    std::optional<Error> failure;  ///< for good
    /// Once a ray is cast.
    std::optional<surface::DisplayMesh> mesh;
    std::optional<surface::Picker> picker;
};

}  // namespace sunder
