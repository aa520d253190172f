#pragma once
#include "gpu/world_buffers.hpp"
#include "render/camera.hpp"
#include "render/shading.hpp"

namespace sunder::render {

/// The bodies of a world as one kind of mesh, in every way that the renderer draws them.
class Walls {
  public:
    virtual ~Walls() = default;

    /// Opaque ones, into the shadow map.
    virtual void drawDepth(const gpu::StateView&, const glm::mat4& lightMatrix) const = 0;
    /// Transparent ones, into the shadow map's veil.
    virtual void drawVeil(const gpu::StateView&, const glm::mat4& lightMatrix) const = 0;
    /// Opaque ones; with `wire` the edges of their triangles over them.
    virtual void drawOpaque(const gpu::StateView&, const Camera&, const Shading&,
                            bool wire) const = 0;
    /// Transparent ones, inside Transparency::draw().
    virtual void drawTransparent(const gpu::StateView&, const Camera&, const Shading&,
                                 bool wire) const = 0;
    /// All, as the edges of their triangles; the polygon mode is set.
    virtual void drawLines(const gpu::StateView&, const Camera&, const Shading&) const = 0;
};

}  // namespace sunder::render
