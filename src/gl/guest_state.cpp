// What of GL 4.1's state (specification, chapter 6, tables 6.5 to 6.61) a guest has to do with, and
// what of newer versions, of the compatibility profile and of extensions comes into its draws.
//
// In no table, as Sunder neither depends on it nor changes it:
// - what only matters where something below is on, which is off: blend colour, logic operation,
//   stencil functions, operations, masks and clear value, sample coverage, sample mask's words,
//   smallest share of sample shading, primitive restart's index, polygon offset's units for lines
//   and points;
// - what only some primitives have, which Sunder draws none of: patch vertices and levels, line
//   stipple, the origin of point sprites (no shader reads gl_PointCoord), hints for smooth lines
//   and polygons;
// - the scissor boxes; program pipelines, which glUseProgram overrules; seamless cube maps, of
//   which Sunder has none; renderbuffers; the generic bindings of textures' buffers and indirect
//   draws; atomic counters and shader storage, which no shader of Sunder's uses (of images, which
//   the solver `compute` does: gl/touched_bindings.hpp);
// - what belongs to objects of the host's: vertex arrays, their element buffer included,
//   framebuffers and their draw and read buffers, transform feedbacks and their buffers;
// - current vertex attributes, which drawing may change (GL 4.1, 2.8.3); no driver is known to do
//   so, and of which type they are cannot be asked;
// - the debug output.
#include "gl/guest_state.hpp"

#include <iterator>
#include <string>

#include "core/types.hpp"
#include "gl/driver.hpp"
#include "gl/guest_arrays.hpp"
#include "gl/guest_feedback.hpp"
#include "gl/guest_tables.hpp"
#include "gl/objects.hpp"

namespace sunder::gl {

using namespace core;

namespace {

constexpr unsigned D = kDepends, C = kChanges;

using F = Functions;

constexpr Capability kCapabilities[] = {
    // What keeps fragments from being written, or changes them.
    {GL_COLOR_LOGIC_OP, false, D},
    {GL_CULL_FACE, false, D | C},
    {GL_DEPTH_TEST, false, D | C},
    {GL_STENCIL_TEST, false, D | C},
    {GL_DEPTH_CLAMP, false, D | C},
    {GL_DITHER, true, D | C},
    {GL_FRAMEBUFFER_SRGB, false, D | C},
    {GL_RASTERIZER_DISCARD, false, D | C},
    {GL_MULTISAMPLE, true, D | C},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, false, D},
    {GL_SAMPLE_ALPHA_TO_ONE, false, D},
    {GL_SAMPLE_COVERAGE, false, D},
    {GL_SAMPLE_MASK, false, D},
    {GL_SAMPLE_SHADING, false, D},
    // What makes other fragments of points and triangles.
    {GL_PROGRAM_POINT_SIZE, false, D},
    {GL_PRIMITIVE_RESTART, false, D},
    {GL_LINE_SMOOTH, false, D},
    {GL_POLYGON_SMOOTH, false, D},
    {GL_POLYGON_OFFSET_FILL, false, D | C},
    {GL_POLYGON_OFFSET_LINE, false, D},
    {GL_POLYGON_OFFSET_POINT, false, D},
    // No shader of Sunder's writes these distances: what is clipped by them is undefined.
    {GL_CLIP_DISTANCE0, false, D},
    {GL_CLIP_DISTANCE1, false, D},
    {GL_CLIP_DISTANCE2, false, D},
    {GL_CLIP_DISTANCE3, false, D},
    {GL_CLIP_DISTANCE4, false, D},
    {GL_CLIP_DISTANCE5, false, D},
    {GL_CLIP_DISTANCE6, false, D},
    {GL_CLIP_DISTANCE7, false, D},
    // Newer than GL 4.1, and extensions.
    {GL_PRIMITIVE_RESTART_FIXED_INDEX, false, D, {&F::ARB_ES3_compatibility}},
    {GL_DEPTH_BOUNDS_TEST_EXT, false, D, {&F::EXT_depth_bounds_test}},
    {GL_RASTER_MULTISAMPLE_EXT, false, D, {&F::EXT_raster_multisample}},
    {GL_CONSERVATIVE_RASTERIZATION_INTEL, false, D, {&F::INTEL_conservative_rasterization}},
    {GL_CONSERVATIVE_RASTERIZATION_NV, false, D, {&F::NV_conservative_raster}},
    {GL_FRAGMENT_COVERAGE_TO_COLOR_NV, false, D, {&F::NV_fragment_coverage_to_color}},
    {GL_REPRESENTATIVE_FRAGMENT_TEST_NV, false, D, {&F::NV_representative_fragment_test}},
    {GL_SHADING_RATE_IMAGE_NV, false, D, {&F::NV_shading_rate_image}},
    // Of the compatibility profile. In the core profile points are always sprites.
    {kAlphaTest, false, D, kCompatibility},
    {kPointSmooth, false, D, kCompatibility},
    {kPointSprite, true, D, kCompatibility},
    {kPolygonStipple, false, D, kCompatibility},
};

template <GLenum Name>
void store(const GLint* value) {
    glPixelStorei(Name, value[0]);
}
template <GLenum Target>
void bind(const GLint* buffer) {
    glBindBuffer(Target, static_cast<GLuint>(buffer[0]));
}
template <GLenum Target>
void bindFramebuffer(const GLint* framebuffer) {
    glBindFramebuffer(Target, static_cast<GLuint>(framebuffer[0]));
}
template <GLenum Target>
void clampColour(const GLint* value) {
    glClampColor(Target, static_cast<GLenum>(value[0]));
}
template <GLenum Name>
void pointParameter(const GLfloat* value) {
    glPointParameterfv(Name, value);
}
template <GLenum Name>
void transfer(const GLfloat* value) {
    Driver::current()->setPixelTransfer(Name, value[0]);
}
void setPolygonMode(const GLint* mode) {
    const auto front = static_cast<GLenum>(mode[0]), back = static_cast<GLenum>(mode[1]);
    if (front == back || !Driver::current()->info().compatibility) {
        glPolygonMode(GL_FRONT_AND_BACK, front);
    } else {
        glPolygonMode(GL_FRONT, front);
        glPolygonMode(GL_BACK, back);
    }
}
void setCullFace(const GLint* face) {
    glCullFace(static_cast<GLenum>(face[0]));
}
void setFrontFace(const GLint* winding) {
    glFrontFace(static_cast<GLenum>(winding[0]));
}
void setDepthFunction(const GLint* function) {
    glDepthFunc(static_cast<GLenum>(function[0]));
}
void setDepthMask(const GLint* mask) {
    glDepthMask(mask[0] != 0);
}
void setProvokingVertex(const GLint* convention) {
    glProvokingVertex(static_cast<GLenum>(convention[0]));
}
void bindVertexArray(const GLint* array) {
    glBindVertexArray(static_cast<GLuint>(array[0]));
}
void useProgram(const GLint* program) {
    glUseProgram(static_cast<GLuint>(program[0]));
}
void setActiveTexture(const GLint* unit) {
    glActiveTexture(static_cast<GLenum>(unit[0]));
}
void setPointSize(const GLfloat* size) {
    glPointSize(size[0]);
}
void setLineWidth(const GLfloat* width) {
    glLineWidth(width[0]);
}
void setClearColour(const GLfloat* colour) {
    glClearColor(colour[0], colour[1], colour[2], colour[3]);
}
void setClearDepth(const GLdouble* depth) {
    glClearDepth(depth[0]);
}

constexpr Value<GLint> kIntegers[] = {
    // The front face's mode and the back's, which only the compatibility profile tells apart.
    {GL_POLYGON_MODE, {GL_FILL, GL_FILL}, D | C, setPolygonMode},
    {GL_CULL_FACE_MODE, {GL_BACK}, D | C, setCullFace},
    {GL_FRONT_FACE, {GL_CCW}, D | C, setFrontFace},
    {GL_DEPTH_FUNC, {GL_LESS}, D | C, setDepthFunction},
    {GL_DEPTH_WRITEMASK, {GL_TRUE}, D | C, setDepthMask},
    {GL_PROVOKING_VERTEX, {GL_LAST_VERTEX_CONVENTION}, D, setProvokingVertex},
    {GL_CLAMP_READ_COLOR, {GL_FIXED_ONLY}, D, clampColour<GL_CLAMP_READ_COLOR>},
    {kClampVertexColour, {GL_TRUE}, D, clampColour<kClampVertexColour>, kCompatibility},
    {kClampFragmentColour, {GL_FIXED_ONLY}, D, clampColour<kClampFragmentColour>, kCompatibility},
    // How texels lie in memory that is read and written.
    {GL_PACK_SWAP_BYTES, {0}, D, store<GL_PACK_SWAP_BYTES>},
    {GL_PACK_LSB_FIRST, {0}, D, store<GL_PACK_LSB_FIRST>},
    {GL_PACK_ROW_LENGTH, {0}, D, store<GL_PACK_ROW_LENGTH>},
    {GL_PACK_IMAGE_HEIGHT, {0}, D, store<GL_PACK_IMAGE_HEIGHT>},
    {GL_PACK_SKIP_ROWS, {0}, D, store<GL_PACK_SKIP_ROWS>},
    {GL_PACK_SKIP_PIXELS, {0}, D, store<GL_PACK_SKIP_PIXELS>},
    {GL_PACK_SKIP_IMAGES, {0}, D, store<GL_PACK_SKIP_IMAGES>},
    {GL_PACK_ALIGNMENT, {4}, D | C, store<GL_PACK_ALIGNMENT>},
    {GL_UNPACK_SWAP_BYTES, {0}, D, store<GL_UNPACK_SWAP_BYTES>},
    {GL_UNPACK_LSB_FIRST, {0}, D, store<GL_UNPACK_LSB_FIRST>},
    {GL_UNPACK_ROW_LENGTH, {0}, D, store<GL_UNPACK_ROW_LENGTH>},
    {GL_UNPACK_IMAGE_HEIGHT, {0}, D, store<GL_UNPACK_IMAGE_HEIGHT>},
    {GL_UNPACK_SKIP_ROWS, {0}, D, store<GL_UNPACK_SKIP_ROWS>},
    {GL_UNPACK_SKIP_PIXELS, {0}, D, store<GL_UNPACK_SKIP_PIXELS>},
    {GL_UNPACK_SKIP_IMAGES, {0}, D, store<GL_UNPACK_SKIP_IMAGES>},
    {GL_UNPACK_ALIGNMENT, {4}, D, store<GL_UNPACK_ALIGNMENT>},
    // What addresses of memory count from. Where a query's result goes is one, too.
    {GL_PIXEL_PACK_BUFFER_BINDING, {0}, D | C, bind<GL_PIXEL_PACK_BUFFER>},
    {GL_PIXEL_UNPACK_BUFFER_BINDING, {0}, D | C, bind<GL_PIXEL_UNPACK_BUFFER>},
    {GL_QUERY_BUFFER_BINDING, {0}, D, bind<GL_QUERY_BUFFER>, {&F::ARB_query_buffer_object}},
    // Bindings that every pass sets for itself.
    {GL_ARRAY_BUFFER_BINDING, {0}, C, bind<GL_ARRAY_BUFFER>},
    {GL_COPY_READ_BUFFER, {0}, C, bind<GL_COPY_READ_BUFFER>},
    {GL_COPY_WRITE_BUFFER, {0}, C, bind<GL_COPY_WRITE_BUFFER>},
    {GL_UNIFORM_BUFFER_BINDING, {0}, C, bind<GL_UNIFORM_BUFFER>},
    {GL_DRAW_FRAMEBUFFER_BINDING, {0}, C, bindFramebuffer<GL_DRAW_FRAMEBUFFER>},
    {GL_READ_FRAMEBUFFER_BINDING, {0}, C, bindFramebuffer<GL_READ_FRAMEBUFFER>},
    {GL_VERTEX_ARRAY_BINDING, {0}, C, bindVertexArray},
    {GL_CURRENT_PROGRAM, {0}, C, useProgram},
    {GL_ACTIVE_TEXTURE, {GL_TEXTURE0}, C, setActiveTexture},
};

constexpr Value<GLfloat> kFloats[] = {
    {GL_POINT_SIZE, {1}, D | C, setPointSize},
    {GL_POINT_FADE_THRESHOLD_SIZE, {1}, D, pointParameter<GL_POINT_FADE_THRESHOLD_SIZE>},
    {GL_LINE_WIDTH, {1}, D, setLineWidth},
    {GL_COLOR_CLEAR_VALUE, {0, 0, 0, 0}, C, setClearColour},
    // Points are of size 1, whatever else the compatibility profile would make of them.
    {kPointSizeMin, {0}, D, pointParameter<kPointSizeMin>, kCompatibility},
    {kPointSizeMax, {1}, D, pointParameter<kPointSizeMax>, kCompatibility},
    {kPointAttenuation, {1, 0, 0}, D, pointParameter<kPointAttenuation>, kCompatibility},
    // What happens to texels on their way to and from memory.
    {kScale[0], {1}, D, transfer<kScale[0]>, kCompatibility},
    {kScale[1], {1}, D, transfer<kScale[1]>, kCompatibility},
    {kScale[2], {1}, D, transfer<kScale[2]>, kCompatibility},
    {kScale[3], {1}, D, transfer<kScale[3]>, kCompatibility},
    {kBias[0], {0}, D, transfer<kBias[0]>, kCompatibility},
    {kBias[1], {0}, D, transfer<kBias[1]>, kCompatibility},
    {kBias[2], {0}, D, transfer<kBias[2]>, kCompatibility},
    {kBias[3], {0}, D, transfer<kBias[3]>, kCompatibility},
    {kMapColour, {0}, D, transfer<kMapColour>, kCompatibility},
};

constexpr Value<GLdouble> kDoubles[] = {
    {GL_DEPTH_CLEAR_VALUE, {1}, D, setClearDepth},
};

}  // namespace

struct GuestState::Saved {
    HostFeedback feedback;
    SavedCapabilities<std::size(kCapabilities)> capabilities{kCapabilities};
    SavedValues<GLint, std::size(kIntegers)> integers{kIntegers};
    SavedValues<GLfloat, std::size(kFloats)> floats{kFloats};
    SavedValues<GLdouble, std::size(kDoubles)> doubles{kDoubles};
    Blending blending;
    Viewports viewports;
    PolygonOffset polygonOffset;
    ClipControl clipControl;
    WindowRectangles windowRectangles;

    template <class Call>
    void eachButFeedback(Call call) {
        call(capabilities);
        call(integers);
        call(floats);
        call(doubles);
        call(blending);
        call(viewports);
        call(polygonOffset);
        call(clipControl);
        call(windowRectangles);
    }
};

GuestState::GuestState(Driver& driver) : driver_(driver), saved_(std::make_unique<Saved>()) {}

GuestState::~GuestState() = default;

void GuestState::refuseWhatCannotBeLeft() const {
    // Sunder's passes ask queries of these kinds, of which one at a time can be active, and their
    // draws would be counted by the host's. GL_TIME_ELAPSED is no trouble: a host may want to know
    // how long Sunder takes.
    constexpr struct {
        GLenum target;
        const char* name;
    } kQueries[] = {
        {GL_SAMPLES_PASSED, "GL_SAMPLES_PASSED"},
        {GL_ANY_SAMPLES_PASSED, "GL_ANY_SAMPLES_PASSED"},
        {GL_ANY_SAMPLES_PASSED_CONSERVATIVE, "GL_ANY_SAMPLES_PASSED_CONSERVATIVE"},
        {GL_PRIMITIVES_GENERATED, "GL_PRIMITIVES_GENERATED"},
        {GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, "GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN"},
    };
    for (const auto& [target, name] : kQueries) {
        if (target == GL_ANY_SAMPLES_PASSED_CONSERVATIVE &&
            !driver_.functions().ARB_ES3_compatibility)
            continue;
        GLint query = 0;
        glGetQueryiv(target, GL_CURRENT_QUERY, &query);
        if (query != 0)
            throw InputError("a query of " + std::string(name) +
                             " is active in the host's OpenGL context; end it before Sunder is "
                             "called");
    }
    // Once another program is used, one that is deleted is gone, and there is no way back to it.
    if (const int program = limit(GL_CURRENT_PROGRAM); program != 0) {
        GLint deleted = GL_FALSE;
        glGetProgramiv(static_cast<GLuint>(program), GL_DELETE_STATUS, &deleted);
        if (deleted)
            throw InputError(
                "the program in use in the host's OpenGL context has been deleted and would not "
                "survive; call glUseProgram(0) before Sunder is called");
    }
    if (!driver_.info().compatibility) return;
    if (limit(kRenderMode) != static_cast<int>(kRender) || limit(kListIndex) != 0)
        throw InputError(
            "the host's OpenGL context selects, gives feedback or makes a display list instead of "
            "drawing; end that before Sunder is called");
}

void GuestState::save() {
    saved_->feedback.save();
    saved_->eachButFeedback([&](auto& part) { part.save(driver_); });
}

// While the host's transform feedback is active, neither it nor the program can be changed: it is
// interrupted first and goes on last.
void GuestState::neutralise() {
    saved_->feedback.interrupt(driver_);
    saved_->eachButFeedback([&](auto& part) { part.neutralise(driver_); });
}

void GuestState::neutraliseAll() {
    saved_->eachButFeedback([&](auto& part) { part.neutraliseAll(driver_); });
}

void GuestState::restore() {
    saved_->eachButFeedback([&](auto& part) { part.restore(driver_); });
    saved_->feedback.goOn(driver_);
}

}  // namespace sunder::gl
