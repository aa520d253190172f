#include "render/renderer.hpp"

#include <optional>

#include "render/backdrop.hpp"
#include "render/camera.hpp"
#include "render/cell_paint.hpp"
#include "render/cell_pass.hpp"
#include "render/object_pass.hpp"
#include "render/picture_target.hpp"
#include "render/scene_bounds.hpp"
#include "render/shadow_map.hpp"
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

}  // namespace

struct Renderer::Impl {
    SceneBounds bounds;
    gl::VertexArray noAttributes = gl::makeVertexArray();
    ShadowMap shadows;
    Backdrop backdrop;
    Passes<CellPass> cells;
    CellPaint paint;
    std::optional<Passes<ObjectPass>> objects;  ///< where the world has any
    PictureTarget target;

    Impl(const World& world, const gpu::WorldBuffers& buffers)
        : bounds(sceneBounds(world)),
          shadows(bounds),
          backdrop(bounds, noAttributes),
          cells(buffers, noAttributes) {
        if (!world.objects().empty()) objects.emplace(world, buffers, noAttributes);
    }

    void drawShadows(const gpu::StateView& state) const {
        shadows.begin();
        // What stands between the sun and the map's box is flattened onto its front instead of
        // being cut off.
        glEnable(GL_DEPTH_CLAMP);
        cells.depth.begin();
        cells.depth.draw(state, shadows.lightMatrix());
        if (objects) {
            objects->depth.begin();
            objects->depth.draw(state, shadows.lightMatrix());
        }
        glDisable(GL_DEPTH_CLAMP);
    }

    /// What draw/light.glsl reads.
    void setLight(const gl::Program& program) const {
        shadows.bind(program);
        setUniform(program, "grounded", bounds.ground);
    }

    void drawSolid(const gpu::StateView& state, const Camera& camera, float wire) const {
        glEnable(GL_CULL_FACE);
        const gl::Program& program = cells.shaded.begin();
        setLight(program);
        paint.bind(program);
        setUniform(program, "wire", wire);
        cells.shaded.draw(state, camera.viewProjection());
        if (!objects) return;
        const gl::Program& smooth = objects->shaded.begin();
        setLight(smooth);
        setUniform(smooth, "eye", camera.eye);
        objects->shaded.draw(state, camera.viewProjection());
    }

    /// Lines hide nothing, so that the far side shows through.
    void drawWireframe(const gpu::StateView& state, const Camera& camera) const {
        glDisable(GL_CULL_FACE);
        glDepthMask(GL_FALSE);
        glEnable(GL_BLEND);
        glBlendEquation(GL_FUNC_ADD);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        const gl::Program& program = cells.lines.begin();
        paint.bind(program);
        setUniform(program, "eye", camera.eye);
        cells.lines.draw(state, camera.viewProjection());
        if (!objects) return;
        setUniform(objects->lines.begin(), "eye", camera.eye);
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
    impl.paint.set(settings.colours);
    const Camera camera = makeCamera(description, aspect, impl.bounds);

    {
        const DrawingState drawing;
        const bool solid = settings.style != DrawStyle::Wireframe;
        if (solid) impl.drawShadows(state);
        impl.target.begin();
        impl.backdrop.draw(camera, solid ? &impl.shadows : nullptr);
        if (solid)
            impl.drawSolid(state, camera, settings.style == DrawStyle::Overlay ? 1.f : 0.f);
        else
            impl.drawWireframe(state, camera);
        impl.target.resolve();
    }
    return impl.target.read();
}

}  // namespace sunder
