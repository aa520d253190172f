#pragma once
#include <functional>

#include "gpu/world_buffers.hpp"
#include "render/camera.hpp"
#include "render/renderer.hpp"

// A small wall in front of a camera, its pictures, and what their pixels say.

inline constexpr int kWidth = 320, kHeight = 200;

/// A wall of 8 x 4 x 1 cells of 0.25 m, its front in the plane z = 0.05, seen from straight in
/// front.
sunder::core::WorldDescription wallDescription();
sunder::scene::CameraDescription frontCamera();

sunder::core::State shifted(const sunder::core::World& world, const sunder::core::Vec3& by);
/// Out of every picture: what is left is the background.
sunder::core::State nowhere(const sunder::core::World& world);

/// Draws pictures of one world, of the size above, and checks that GL found nothing wrong. To make
/// one takes longer than to draw with it.
class Painter {
  public:
    /// `world` must outlive it.
    explicit Painter(const sunder::core::World& world);
    sunder::image::Image picture(const sunder::core::State& state,
                                 const sunder::scene::CameraDescription& camera,
                                 sunder::render::RenderSettings settings);

  private:
    sunder::gpu::WorldBuffers buffers_;
    sunder::gpu::StateUpload upload_;
    sunder::render::Renderer renderer_;
};

/// One picture, by a painter of its own.
sunder::image::Image picture(const sunder::core::World& world, const sunder::core::State& state,
                             const sunder::scene::CameraDescription& camera,
                             sunder::render::RenderSettings settings);
sunder::image::Image picture(
    const sunder::core::World& world, const sunder::core::State& state,
    const sunder::scene::CameraDescription& camera,
    sunder::render::DrawStyle style = sunder::render::DrawStyle::Solid,
    sunder::render::DrawnMesh mesh = sunder::render::DrawnMesh::Simulation);
/// Pixel coordinates, from the top left, of a point.
glm::vec2 project(const sunder::core::World& world,
                  const sunder::scene::CameraDescription& description, const glm::vec3& p);

int brightness(const sunder::image::Image& image, int x, int y);
int difference(const sunder::image::Image& a, const sunder::image::Image& b, int x, int y);
/// Number of pixels for which `counts` holds and the pictures differ by more than `threshold` of
/// 255.
int differing(
    const sunder::image::Image& a, const sunder::image::Image& b, int threshold,
    const std::function<bool(float x, float y)>& counts = [](float, float) { return true; });
