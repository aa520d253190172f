#pragma once
#include <memory>

#include "gpu/world_buffers.hpp"
#include "image/image.hpp"
#include "render/cell_colours.hpp"
#include "scene/scene.hpp"

namespace sunder {

enum class DrawStyle {
    Solid,
    Wireframe,  ///< edges of all tetrahedra on an empty background of sky and ground
    Overlay,    ///< solid with the wireframe over it
};

struct RenderSettings {
    int width = 1280, height = 720;
    int samples = 4;  ///< multisampling; clamped to what the device has
    DrawStyle style = DrawStyle::Solid;
    const CellColours* colours = nullptr;  ///< of walls; null: the materials' own
};

/// Draws a world's simulation mesh (thesis, figure 6.6): sky, ground, sun with shadow, walls whose
/// faces and flat normals a geometry shader makes from the node buffer. Cracks (broken bonds
/// between faces that still touch) show as dark lines. Objects are smooth.
class Renderer {
  public:
    Renderer(const World&, const gpu::WorldBuffers&);
    ~Renderer();

    /// Draws one picture off screen and reads it back. Waits for the GPU.
    Image draw(const gpu::StateView&, const CameraDescription&, const RenderSettings&);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sunder
