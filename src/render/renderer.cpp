#include "render/renderer.hpp"

#include <optional>

#include "gpu/pass_timer.hpp"
#include "render/backdrop.hpp"
#include "render/camera.hpp"
#include "render/display_walls.hpp"
#include "render/object_pass.hpp"
#include "render/picture_target.hpp"
#include "render/scene_bounds.hpp"
#include "render/simulation_walls.hpp"
#include "render/transparency.hpp"
#include "render/uniforms.hpp"

namespace sunder::render {

using namespace core;

namespace {

/// What drawing needs of GL's state, for as long as it lives; the simulation's passes set little
/// and find it undone.
class DrawingState {
  public:
    DrawingState() {
        glDisable(GL_RASTERIZER_DISCARD);
        glDisable(GL_BLEND);
        glDisable(GL_SCISSOR_TEST);
        glDisable(GL_STENCIL_TEST);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glDepthMask(GL_TRUE);
        glDepthFunc(GL_LEQUAL);
        glFrontFace(GL_CCW);
        glCullFace(GL_BACK);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_MULTISAMPLE);
        glEnable(GL_FRAMEBUFFER_SRGB);
        glDisable(GL_DITHER);  // a picture must not depend on where on the screen it is
    }
    ~DrawingState() {
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_CULL_FACE);
        glDisable(GL_BLEND);
        glDisable(GL_DEPTH_CLAMP);
        glDisable(GL_MULTISAMPLE);
        glDisable(GL_FRAMEBUFFER_SRGB);
        glDepthMask(GL_TRUE);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        ShadowMap::unbind();
        glBindVertexArray(0);
        glUseProgram(0);
    }
    DrawingState(const DrawingState&) = delete;
    DrawingState& operator=(const DrawingState&) = delete;
};

}  // namespace

struct Renderer::Impl {
    /// Objects: one pass per way of drawing.
    struct Objects {
        ObjectPass depth, shaded, lines;

        Objects(const World& world, const gpu::WorldBuffers& buffers,
                const gl::VertexArray& noAttributes)
            : depth(CellPass::Output::Depth, world, buffers, noAttributes),
              shaded(CellPass::Output::Shaded, world, buffers, noAttributes),
              lines(CellPass::Output::Lines, world, buffers, noAttributes) {}
    };

    const World& world;
    const gpu::WorldBuffers& buffers;
    SceneBounds bounds;
    gl::VertexArray noAttributes = gl::makeVertexArray();
    Shading shading;
    Backdrop backdrop;
    // Made when they are first drawn.
    std::optional<DisplayWalls> displayWalls;
    std::optional<SimulationWalls> simulationWalls;
    std::optional<Objects> objects;            ///< where the world has any
    std::optional<Transparency> transparency;  ///< where a material is transparent
    PictureTarget target;

    Impl(const World& w, const gpu::WorldBuffers& b, const Impl* like)
        : world(w),
          buffers(b),
          bounds(sceneBounds(world)),
          shading(world, bounds, noAttributes, like ? &like->shading : nullptr),
          backdrop(bounds, noAttributes) {
        if (!world.objects().empty()) objects.emplace(world, buffers, noAttributes);
        if (shading.looks().anyTransparent()) transparency.emplace(noAttributes);
    }

    DisplayWalls& displayed() {
        if (!displayWalls) displayWalls.emplace(world, buffers);
        return *displayWalls;
    }

    const Walls& walls(DrawnMesh mesh) {
        if (mesh == DrawnMesh::Display) return displayed();
        if (!simulationWalls)
            simulationWalls.emplace(buffers, noAttributes, transparency.has_value());
        return *simulationWalls;
    }

    void drawShadows(const gpu::StateView& state, const Walls& walls) const {
        const ShadowMap& shadows = shading.shadows();
        shadows.begin();
        // What stands between the sun and the map's box is flattened onto its front instead of
        // being cut off.
        glEnable(GL_DEPTH_CLAMP);
        shading.looks().bind();
        walls.drawDepth(state, shadows.lightMatrix());
        if (objects) {
            objects->depth.begin();
            objects->depth.draw(state, shadows.lightMatrix());
        }
        if (transparency) {
            shadows.beginVeil();
            walls.drawVeil(state, shadows.lightMatrix());
            ShadowMap::endVeil();
        }
        glDisable(GL_DEPTH_CLAMP);
    }

    void drawOpaque(const gpu::StateView& state, const Camera& camera, const Walls& walls,
                    bool wire) const {
        glEnable(GL_CULL_FACE);
        walls.drawOpaque(state, camera, shading, wire);
        if (objects) {
            shading.bind(objects->shaded.begin(), camera.eye);
            objects->shaded.draw(state, camera.viewProjection());
        }
    }

    void drawTransparent(const gpu::StateView& state, const Camera& camera, const Walls& walls,
                         bool wire) {
        if (!transparency) return;
        glEnable(GL_CULL_FACE);
        transparency->draw(target, [&] { walls.drawTransparent(state, camera, shading, wire); });
    }

    /// Lines hide nothing, so that the far side shows through.
    void drawWireframe(const gpu::StateView& state, const Camera& camera, const Walls& walls) {
        glDisable(GL_CULL_FACE);
        glDepthMask(GL_FALSE);
        glEnable(GL_BLEND);
        glBlendEquation(GL_FUNC_ADD);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        walls.drawLines(state, camera, shading);
        if (!objects) return;
        shading.bind(objects->lines.begin(), camera.eye);
        objects->lines.draw(state, camera.viewProjection());
    }
};

std::string_view toString(DrawnMesh mesh) {
    return mesh == DrawnMesh::Display ? "display" : "simulation";
}

std::string_view toString(DrawStyle style) {
    switch (style) {
        case DrawStyle::Solid:
            return "solid";
        case DrawStyle::Wireframe:
            return "wireframe";
        case DrawStyle::Overlay:
            return "overlay";
    }
    return "";
}

Renderer::Renderer(const World& world, const gpu::WorldBuffers& buffers, const Renderer* like)
    : impl_(std::make_unique<Impl>(world, buffers, like ? like->impl_.get() : nullptr)) {}

Renderer::~Renderer() = default;

const surface::DisplayMesh& Renderer::displayMesh() {
    return impl_->displayed().mesh();
}

void Renderer::render(const gpu::StateView& state, const scene::CameraDescription& description,
                      const RenderSettings& settings) {
    Impl& impl = *impl_;
    if (!impl.target.fits(settings.width, settings.height, settings.samples))
        impl.target = PictureTarget(settings.width, settings.height, settings.samples);
    const float aspect = static_cast<float>(settings.width) / static_cast<float>(settings.height);
    impl.shading.paint().set(settings.colours);
    const Camera camera = makeCamera(description, aspect, impl.bounds);

    const DrawingState drawing;
    const Walls& walls = impl.walls(settings.mesh);
    const bool solid = settings.style != DrawStyle::Wireframe;
    const bool wire = settings.style == DrawStyle::Overlay;
    if (solid) {
        const gpu::TimedPass timed(settings.timer, "shadows");
        impl.drawShadows(state, walls);
    }
    impl.target.begin(settings.background.value_or(glm::vec3(0)));
    // The background comes late: what is hidden costs nothing.
    if (solid) {
        const gpu::TimedPass timed(settings.timer, "walls");
        impl.drawOpaque(state, camera, walls, wire);
    }
    if (!settings.background) {
        const gpu::TimedPass timed(settings.timer, "sky and ground");
        impl.backdrop.draw(camera, impl.shading, solid);
    }
    const gpu::TimedPass timed(settings.timer, solid ? "glass" : "wireframe");
    if (solid)
        impl.drawTransparent(state, camera, walls, wire);
    else
        impl.drawWireframe(state, camera, walls);
    impl.target.resolve();
}

void Renderer::show(int left, int bottom) const {
    impl_->target.show(left, bottom);
}

image::Image Renderer::read() const {
    return impl_->target.read();
}

image::Image Renderer::draw(const gpu::StateView& state, const scene::CameraDescription& camera,
                            const RenderSettings& settings) {
    render(state, camera, settings);
    return read();
}

}  // namespace sunder::render
