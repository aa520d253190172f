#include "render/renderer.hpp"

#include <optional>

#include "render/backdrop.hpp"
#include "render/camera.hpp"
#include "render/cell_pass.hpp"
#include "render/object_pass.hpp"
#include "render/picture_target.hpp"
#include "render/scene_bounds.hpp"
#include "render/shading.hpp"
#include "render/transparency.hpp"
#include "render/uniforms.hpp"

namespace sunder {
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

/// Passes of one kind: one per way of drawing.
template <typename Pass>
struct Passes {
    Pass depth, shaded, lines;

    template <typename... Arguments>
    explicit Passes(const Arguments&... arguments)
        : depth(CellPass::Output::Depth, arguments...),
          shaded(CellPass::Output::Shaded, arguments...),
          lines(CellPass::Output::Lines, arguments...) {}
};

/// What draws materials that let light through.
struct Glass {
    CellPass veil, shaded;
    Transparency layers;

    Glass(const gpu::WorldBuffers& buffers, const gl::VertexArray& noAttributes)
        : veil(CellPass::Output::Veil, buffers, noAttributes),
          shaded(CellPass::Output::Transparent, buffers, noAttributes),
          layers(noAttributes) {}
};

}  // namespace

struct Renderer::Impl {
    SceneBounds bounds;
    gl::VertexArray noAttributes = gl::makeVertexArray();
    Shading shading;
    Backdrop backdrop;
    Passes<CellPass> cells;
    std::optional<Passes<ObjectPass>> objects;  ///< where the world has any
    std::optional<Glass> glass;                 ///< where a material is transparent
    PictureTarget target;

    Impl(const World& world, const gpu::WorldBuffers& buffers)
        : bounds(sceneBounds(world)),
          shading(world, bounds, noAttributes),
          backdrop(bounds, noAttributes),
          cells(buffers, noAttributes) {
        if (!world.objects().empty()) objects.emplace(world, buffers, noAttributes);
        if (shading.looks().anyTransparent()) glass.emplace(buffers, noAttributes);
    }

    void drawShadows(const gpu::StateView& state) const {
        const ShadowMap& shadows = shading.shadows();
        shadows.begin();
        // What stands between the sun and the map's box is flattened onto its front instead of
        // being cut off.
        glEnable(GL_DEPTH_CLAMP);
        shading.looks().bind();
        cells.depth.begin();
        cells.depth.draw(state, shadows.lightMatrix());
        if (objects) {
            objects->depth.begin();
            objects->depth.draw(state, shadows.lightMatrix());
        }
        if (glass) {
            shadows.beginVeil();
            glass->veil.begin();
            glass->veil.draw(state, shadows.lightMatrix());
            ShadowMap::endVeil();
        }
        glDisable(GL_DEPTH_CLAMP);
    }

    void drawCells(const CellPass& pass, const gpu::StateView& state, const Camera& camera,
                   float wire) const {
        const gl::Program& program = pass.begin();
        shading.bind(program, camera.eye);
        setUniform(program, "wire", wire);
        pass.draw(state, camera.viewProjection());
    }

    void drawSolid(const gpu::StateView& state, const Camera& camera, float wire) {
        glEnable(GL_CULL_FACE);
        drawCells(cells.shaded, state, camera, wire);
        if (objects) {
            shading.bind(objects->shaded.begin(), camera.eye);
            objects->shaded.draw(state, camera.viewProjection());
        }
        if (glass)
            glass->layers.draw(target, [&] { drawCells(glass->shaded, state, camera, wire); });
    }

    /// Lines hide nothing, so that the far side shows through.
    void drawWireframe(const gpu::StateView& state, const Camera& camera) const {
        glDisable(GL_CULL_FACE);
        glDepthMask(GL_FALSE);
        glEnable(GL_BLEND);
        glBlendEquation(GL_FUNC_ADD);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        shading.bind(cells.lines.begin(), camera.eye);
        cells.lines.draw(state, camera.viewProjection());
        if (!objects) return;
        shading.bind(objects->lines.begin(), camera.eye);
        objects->lines.draw(state, camera.viewProjection());
    }
};

Renderer::Renderer(const World& world, const gpu::WorldBuffers& buffers)
    : impl_(std::make_unique<Impl>(world, buffers)) {}

Renderer::~Renderer() = default;

Image Renderer::draw(const gpu::StateView& state, const CameraDescription& description,
                     const RenderSettings& settings) {
    Impl& impl = *impl_;
    if (!impl.target.fits(settings.width, settings.height, settings.samples))
        impl.target = PictureTarget(settings.width, settings.height, settings.samples);
    const float aspect = static_cast<float>(settings.width) / static_cast<float>(settings.height);
    const Camera camera = makeCamera(description, aspect, impl.bounds);

    {
        const DrawingState drawing;
        const bool solid = settings.style != DrawStyle::Wireframe;
        if (solid) impl.drawShadows(state);
        impl.target.begin();
        impl.backdrop.draw(camera, impl.shading, solid);
        if (solid)
            impl.drawSolid(state, camera, settings.style == DrawStyle::Overlay ? 1.f : 0.f);
        else
            impl.drawWireframe(state, camera);
        impl.target.resolve();
    }
    return impl.target.read();
}

}  // namespace sunder
