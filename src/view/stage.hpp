#pragma once
#include <optional>

#include "render/renderer.hpp"
#include "surface/picker.hpp"
#include "view/played_scene.hpp"

namespace sunder::view {

/// A simulation with all that draws it and finds things in it. Made whole or not at all: while a
/// new one fails, the old one goes on.
class Stage {
  public:
    /// `like`: another one, with which it shares what it can. Throws InputError for a scene that
    /// cannot be laid out or drawn.
    Stage(scene::Scene scene, const std::string& solver, bool hits, const core::State* state,
          const Stage* like)
        : simulation(std::move(scene), solver, hits, state),
          renderer(simulation.world(), simulation.buffers(), like ? &like->renderer : nullptr),
          colours(simulation.world()),
          picker_(simulation.world(), renderer.displayMesh()) {}

    /// What is under a ray.
    std::optional<surface::Spot> pick(const core::Vec3& origin, const core::Vec3& direction) {
        return picker_.pick(simulation.state(), origin, direction);
    }

    /// Draws a small picture: some programs are made when they are first used, and what is wrong
    /// with one has to show before this stage is the one that goes on.
    void rehearse(render::DrawnMesh mesh, render::DrawStyle style) {
        render::RenderSettings small;
        small.width = small.height = 16;
        small.mesh = mesh;
        small.style = style;
        renderer.render(simulation.view(), simulation.scene().camera, small);
    }

    PlayedScene simulation;
    render::Renderer renderer;
    render::CellColours colours;

  private:
    surface::Picker picker_;
};

}  // namespace sunder::view
