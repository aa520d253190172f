#pragma once
#include <functional>

#include "gpu/world_buffers.hpp"
#include "render/camera.hpp"
#include "render/renderer.hpp"

// A small wall in front of a camera, its pictures, and what their pixels say.
namespace sunder {

inline constexpr int kWidth = 320, kHeight = 200;

/// A wall of 8 x 4 x 1 cells of 0.25 m, its front in the plane z = 0.05, seen from straight in
/// front.
WorldDescription wallDescription();
CameraDescription frontCamera();

State shifted(const World& world, const Vec3& by);
/// Out of every picture: what is left is the background.
State nowhere(const World& world);

/// Draws pictures of one world, of the size above, and checks that GL found nothing wrong. To make
/// one takes longer than to draw with it.
class Painter {
  public:
    /// `world` must outlive it.
    explicit Painter(const World& world);
    Image picture(const State& state, const CameraDescription& camera, RenderSettings settings);

  private:
    gpu::WorldBuffers buffers_;
    gpu::StateUpload upload_;
    Renderer renderer_;
};

/// One picture, by a painter of its own.
Image picture(const World& world, const State& state, const CameraDescription& camera,
              RenderSettings settings);
Image picture(const World& world, const State& state, const CameraDescription& camera,
              DrawStyle style = DrawStyle::Solid, DrawnMesh mesh = DrawnMesh::Simulation);
/// Pixel coordinates, from the top left, of a point.
glm::vec2 project(const World& world, const CameraDescription& description, const glm::vec3& p);

int brightness(const Image& image, int x, int y);
int difference(const Image& a, const Image& b, int x, int y);
/// Number of pixels for which `counts` holds and the pictures differ by more than `threshold` of
/// 255.
int differing(
    const Image& a, const Image& b, int threshold,
    const std::function<bool(float x, float y)>& counts = [](float, float) { return true; });

}  // namespace sunder
