#include "render/renderer.hpp"

#include <optional>

#include "render/backdrop.hpp"
#include "render/camera.hpp"
#include "render/cell_pass.hpp"
#include "render/display_pass.hpp"
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
        : depth(Pass::Output::Depth, arguments...),
          shaded(Pass::Output::Shaded, arguments...),
          lines(Pass::Output::Lines, arguments...) {}
};

/// The same for what lets light through.
template <typename Pass>
struct GlassPasses {
    Pass veil, shaded;

    template <typename... Arguments>
    explicit GlassPasses(const Arguments&... arguments)
        : veil(Pass::Output::Veil, arguments...), shaded(Pass::Output::Transparent, arguments...) {}
};

/// The display mesh and its passes.
struct Display {
    DisplayMesh mesh;
    DisplayBuffers buffers;
    Passes<DisplayPass> passes;
    std::optional<GlassPasses<DisplayPass>> glass;  ///< where there is any

    Display(const World& world, const gpu::WorldBuffers& worldBuffers)
        : mesh(world), buffers(mesh), passes(worldBuffers, buffers) {
        if (!buffers.empty(DisplayBuffers::Part::Transparent)) glass.emplace(worldBuffers, buffers);
    }
};

}  // namespace

struct Renderer::Impl {
    const World& world;
    const gpu::WorldBuffers& worldBuffers;
    SceneBounds bounds;
    gl::VertexArray noAttributes = gl::makeVertexArray();
    Shading shading;
    Backdrop backdrop;
    Passes<CellPass> cells;
    std::optional<Display> display;              ///< once it has been asked for
    std::optional<Passes<ObjectPass>> objects;   ///< where the world has any
    std::optional<GlassPasses<CellPass>> glass;  ///< where a material lets light through
    Transparency transparency;
    PictureTarget target;

    Impl(const World& w, const gpu::WorldBuffers& buffers)
        : world(w),
          worldBuffers(buffers),
          bounds(sceneBounds(world)),
          shading(world, bounds, noAttributes),
          backdrop(bounds, noAttributes),
          cells(buffers, noAttributes),
          transparency(noAttributes) {
        if (!world.objects().empty()) objects.emplace(world, buffers, noAttributes);
        if (shading.looks().anyTransparent()) glass.emplace(buffers, noAttributes);
    }

    Display& displayed() {
        if (!display) display.emplace(world, worldBuffers);
        return *display;
    }

    void drawShadows(const gpu::StateView& state, DrawnMesh mesh) {
        const ShadowMap& shadows = shading.shadows();
        const bool simulation = mesh == DrawnMesh::Simulation;
        shadows.begin();
        // What stands between the sun and the map's box is flattened onto its front instead of
        // being cut off.
        glEnable(GL_DEPTH_CLAMP);
        shading.looks().bind();
        if (simulation) {
            cells.depth.begin();
            cells.depth.draw(state, shadows.lightMatrix());
        } else {
            const DisplayPass& pass = displayed().passes.depth;
            pass.begin();
            pass.draw(state, shadows.lightMatrix(), DisplayBuffers::Part::Opaque);
        }
        if (objects) {
            objects->depth.begin();
            objects->depth.draw(state, shadows.lightMatrix());
        }
        if (glass) {
            shadows.beginVeil();
            if (simulation) {
                glass->veil.begin();
                glass->veil.draw(state, shadows.lightMatrix());
            } else if (const auto& displayGlass = displayed().glass) {
                displayGlass->veil.begin();
                displayGlass->veil.draw(state, shadows.lightMatrix(),
                                        DisplayBuffers::Part::Transparent);
            }
            ShadowMap::endVeil();
        }
        glDisable(GL_DEPTH_CLAMP);
    }

    void drawOpaque(const gpu::StateView& state, const Camera& camera, DrawnMesh mesh, float wire) {
        glEnable(GL_CULL_FACE);
        if (mesh == DrawnMesh::Simulation)
            drawCells(cells.shaded, state, camera, wire);
        else
            drawDisplay(state, camera, wire > 0);
        if (objects) {
            shading.bind(objects->shaded.begin(), camera.eye);
            objects->shaded.draw(state, camera.viewProjection());
        }
    }

    void drawCells(const CellPass& pass, const gpu::StateView& state, const Camera& camera,
                   float wire) const {
        const gl::Program& program = pass.begin();
        shading.bind(program, camera.eye);
        setUniform(program, "wire", wire);
        pass.draw(state, camera.viewProjection());
    }

    void drawTransparent(const gpu::StateView& state, const Camera& camera, DrawnMesh mesh,
                         float wire) {
        if (!glass) return;
        glEnable(GL_CULL_FACE);
        transparency.draw(target, [&] { drawGlass(state, camera, mesh, wire); });
    }

    void drawGlass(const gpu::StateView& state, const Camera& camera, DrawnMesh mesh, float wire) {
        if (mesh == DrawnMesh::Simulation) {
            drawCells(glass->shaded, state, camera, wire);
        } else if (const auto& displayGlass = displayed().glass) {
            shading.bind(displayGlass->shaded.begin(), camera.eye);
            displayGlass->shaded.draw(state, camera.viewProjection(),
                                      DisplayBuffers::Part::Transparent);
        }
    }

    void drawDisplay(const gpu::StateView& state, const Camera& camera, bool wire) {
        const DisplayPass& pass = displayed().passes.shaded;
        shading.bind(pass.begin(), camera.eye);
        // Lines in front of the surface that they are on.
        if (wire) glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(1, 2);
        pass.draw(state, camera.viewProjection(), DisplayBuffers::Part::Opaque);
        glDisable(GL_POLYGON_OFFSET_FILL);
        if (!wire) return;
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        drawDisplayLines(state, camera, glm::vec4(0.02f, 0.02f, 0.02f, 0.5f));
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }

    void drawDisplayLines(const gpu::StateView& state, const Camera& camera,
                          const glm::vec4& colour) {
        glDepthMask(GL_FALSE);
        glEnable(GL_BLEND);
        glBlendEquation(GL_FUNC_ADD);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        setUniform(displayed().passes.lines.begin(), "lineColour", colour);
        displayed().passes.lines.draw(state, camera.viewProjection(), DisplayBuffers::Part::Opaque);
        displayed().passes.lines.draw(state, camera.viewProjection(),
                                      DisplayBuffers::Part::Transparent);
        glDisable(GL_BLEND);
        glDepthMask(GL_TRUE);
    }

    /// Lines hide nothing, so that the far side shows through.
    void drawWireframe(const gpu::StateView& state, const Camera& camera, DrawnMesh mesh) {
        glDisable(GL_CULL_FACE);
        glDepthMask(GL_FALSE);
        glEnable(GL_BLEND);
        glBlendEquation(GL_FUNC_ADD);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        if (mesh == DrawnMesh::Simulation) {
            shading.bind(cells.lines.begin(), camera.eye);
            cells.lines.draw(state, camera.viewProjection());
        } else {
            drawDisplayLines(state, camera, glm::vec4(0.05f, 0.04f, 0.03f, 0.6f));
            glEnable(GL_BLEND);
        }
        if (!objects) return;
        shading.bind(objects->lines.begin(), camera.eye);
        objects->lines.draw(state, camera.viewProjection());
    }
};

Renderer::Renderer(const World& world, const gpu::WorldBuffers& buffers)
    : impl_(std::make_unique<Impl>(world, buffers)) {}

Renderer::~Renderer() = default;

const DisplayMesh& Renderer::displayMesh() {
    return impl_->displayed().mesh;
}

void Renderer::render(const gpu::StateView& state, const CameraDescription& description,
                      const RenderSettings& settings) {
    Impl& impl = *impl_;
    if (!impl.target.fits(settings.width, settings.height, settings.samples))
        impl.target = PictureTarget(settings.width, settings.height, settings.samples);
    const float aspect = static_cast<float>(settings.width) / static_cast<float>(settings.height);
    const Camera camera = makeCamera(description, aspect, impl.bounds);

    const DrawingState drawing;
    const bool solid = settings.style != DrawStyle::Wireframe;
    if (solid) impl.drawShadows(state, settings.mesh);
    impl.target.begin(settings.background.value_or(glm::vec3(0)));
    const float wire = settings.style == DrawStyle::Overlay ? 1.f : 0.f;
    // The background comes late: what is hidden costs nothing.
    if (solid) impl.drawOpaque(state, camera, settings.mesh, wire);
    if (!settings.background) impl.backdrop.draw(camera, impl.shading, solid);
    if (solid)
        impl.drawTransparent(state, camera, settings.mesh, wire);
    else
        impl.drawWireframe(state, camera, settings.mesh);
    impl.target.resolve();
}

Image Renderer::draw(const gpu::StateView& state, const CameraDescription& camera,
                     const RenderSettings& settings) {
    render(state, camera, settings);
    return impl_->target.read();
}

}  // namespace sunder
