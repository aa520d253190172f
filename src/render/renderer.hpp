#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string_view>

#include "gpu/world_buffers.hpp"
#include "image/image.hpp"
#include "render/cell_colours.hpp"
#include "scene/scene.hpp"
#include "surface/display_mesh.hpp"

namespace sunder::render {

enum class DrawnMesh {
    Display,     ///< what is seen: sections with torn edges (surface/display_mesh.hpp)
    Simulation,  ///< the tetrahedra's hull
};

enum class DrawStyle {
    Solid,
    Wireframe,  ///< edges of all triangles on an empty background of sky and ground
    Overlay,    ///< solid with the wireframe over it
};

inline constexpr DrawnMesh kDrawnMeshes[] = {DrawnMesh::Display, DrawnMesh::Simulation};
inline constexpr DrawStyle kDrawStyles[] = {DrawStyle::Solid, DrawStyle::Wireframe,
                                            DrawStyle::Overlay};
/// As the command line calls them.
std::string_view toString(DrawnMesh);
std::string_view toString(DrawStyle);

struct RenderSettings {
    int width = 1280, height = 720;
    int samples = 4;  ///< multisampling; clamped to what the device has
    DrawnMesh mesh = DrawnMesh::Display;
    /// Linear RGB instead of sky and ground, to cut walls out by.
    std::optional<glm::vec3> background = std::nullopt;
    DrawStyle style = DrawStyle::Solid;
    const CellColours* colours = nullptr;  ///< of walls; null: the materials' own
    gpu::PassTimer* timer = nullptr;       ///< of shadows, backdrop and walls
};

/// Draws a world: sky, ground, sun with shadow, objects, and walls, either as their display mesh
/// (thesis, figure 8.1) or as their simulation mesh (figure 6.6), whose faces and flat normals a
/// geometry shader makes from the node buffer and whose cracks (broken bonds between faces that
/// still touch) show as dark lines.
class Renderer {
  public:
    /// `like`: one of the same context, whose textures it shares where they are what this world
    /// needs: making them takes a software driver longer than all else.
    Renderer(const core::World&, const gpu::WorldBuffers&, const Renderer* like = nullptr);
    ~Renderer();

    /// The display mesh, made when it is first drawn.
    const surface::DisplayMesh& displayMesh();

    /// Draws one picture off screen.
    void render(const gpu::StateView&, const scene::CameraDescription&, const RenderSettings&);
    /// Copies the last one into a window's framebuffer, its lower left corner at these pixels: the
    /// same bytes that read() gives.
    void show(int left, int bottom) const;
    /// Reads the last one back: waits for the GPU.
    image::Image read() const;
    /// Draws one and reads it back.
    image::Image draw(const gpu::StateView&, const scene::CameraDescription&,
                      const RenderSettings&);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace sunder::render
