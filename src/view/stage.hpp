#pragma once
#include <optional>

#include "render/renderer.hpp"
#include "view/picker.hpp"
#include "view/simulation.hpp"

namespace sunder::view {

/// A simulation with all that draws it and finds things in it. Made whole or not at all: while a
/// new one fails, the old one goes on.
class Stage {
  public:
    Stage(Scene scene, const std::string& solver, bool hits, const State* state = nullptr)
        : simulation(std::move(scene), solver, hits, state),
          renderer(simulation.world(), simulation.buffers()),
          colours(simulation.world()) {}

    /// What is under a ray. The first call makes the picker.
    std::optional<Spot> pick(const Vec3& origin, const Vec3& direction) {
        if (!picker_) picker_.emplace(simulation.world(), renderer.displayMesh());
        return picker_->pick(simulation.state(), origin, direction);
    }

    Simulation simulation;
    Renderer renderer;
    CellColours colours;

  private:
    std::optional<Picker> picker_;
};

}  // namespace sunder::view
