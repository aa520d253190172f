// The table of hostile states.
#include <iterator>
#include <string_view>

#include "gpu/hostile_host.hpp"

using namespace sunder;
using namespace hostile;

namespace {

using Host = HostileHost;
using Setting = HostileHost::Setting;

template <GLenum Capability>
void enable(Host&) {
    glEnable(Capability);
}
template <GLenum Capability>
void disable(Host&) {
    glDisable(Capability);
}
template <GLenum Name, int Value>
void store(Host&) {
    glPixelStorei(Name, Value);
}

void bindEveryUnit(Host& host) {
    for (int unit = 0; unit < integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS); ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (std::size_t i = 0; i < std::size(kTargets); ++i)
            glBindTexture(kTargets[i], host.textures[i]);
        if (unit % 3 == 1) glBindTexture(GL_TEXTURE_2D, host.plain);
        if (unit % 3 == 2) glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    }
    glActiveTexture(GL_TEXTURE17);
}
void bindSamplers(Host& host) {
    for (int unit = 0; unit < integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS); ++unit)
        glBindSampler(static_cast<GLuint>(unit), host.sampler);
}
void bindImages(Host& host) {
    if (!glBindImageTexture) return;
    for (int unit = 0; unit < integer(GL_MAX_IMAGE_UNITS); ++unit)
        glBindImageTexture(static_cast<GLuint>(unit), host.plain, 0, GL_FALSE, 0, GL_READ_WRITE,
                           GL_RGBA8);
}
void blendStrangely(Host&) {
    glEnable(GL_BLEND);
    glBlendColor(0.1f, 0.2f, 0.3f, 0.4f);
    glBlendFuncSeparate(GL_CONSTANT_COLOR, GL_SRC_ALPHA, GL_ZERO, GL_ONE);
    glBlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_MIN);
}
void blendEachStrangely(Host&) {
    for (GLuint i = 0; i < static_cast<GLuint>(integer(GL_MAX_DRAW_BUFFERS)); ++i) {
        if (i % 2)
            glEnablei(GL_BLEND, i);
        else
            glDisablei(GL_BLEND, i);
        glBlendFunci(i, i % 3 ? GL_ZERO : GL_DST_COLOR, i % 2 ? GL_ONE : GL_SRC_ALPHA);
        glBlendEquationi(i, i % 2 ? GL_MAX : GL_FUNC_SUBTRACT);
    }
}
void maskEach(Host&) {
    for (GLuint i = 0; i < static_cast<GLuint>(integer(GL_MAX_DRAW_BUFFERS)); ++i)
        glColorMaski(i, i % 2 == 0, i % 3 == 0, GL_FALSE, i % 2 == 1);
}
void moveViewports(Host&) {
    for (GLuint i = 0; i < static_cast<GLuint>(integer(GL_MAX_VIEWPORTS)); ++i) {
        const auto shift = static_cast<float>(i);
        glViewportIndexedf(i, 1 + shift, 2, 3.5f, 4 + shift);
        glDepthRangeIndexed(i, 0.9, 0.1);
        glScissorIndexed(i, 1, static_cast<GLint>(i), 2, 3);
        if (i % 3 == 0) glEnablei(GL_SCISSOR_TEST, i);
    }
}
void refuseDepthAndStencil(Host&) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_NEVER);
    glDepthMask(GL_FALSE);
    glClearDepth(0.123456789);
    glEnable(GL_STENCIL_TEST);
    glStencilFuncSeparate(GL_FRONT, GL_NEVER, 3, 0x55u);
    glStencilFuncSeparate(GL_BACK, GL_LESS, 5, 0xFFFFFFFFu);
    glStencilOpSeparate(GL_FRONT, GL_INCR, GL_DECR, GL_INVERT);
    glStencilOpSeparate(GL_BACK, GL_ZERO, GL_REPLACE, GL_INCR_WRAP);
    glStencilMaskSeparate(GL_FRONT, 0x0Fu);
    glStencilMaskSeparate(GL_BACK, 0xF0u);
    glClearStencil(7);
}
void thinSamples(Host&) {
    glEnable(GL_SAMPLE_COVERAGE);
    glSampleCoverage(0, GL_TRUE);
    glEnable(GL_SAMPLE_MASK);
    glSampleMaski(0, 0);
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glEnable(GL_SAMPLE_ALPHA_TO_ONE);
    glEnable(GL_SAMPLE_SHADING);
    glMinSampleShading(0.75f);
}
void offsetPolygons(Host&) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    glEnable(GL_POLYGON_OFFSET_LINE);
    glEnable(GL_POLYGON_OFFSET_POINT);
    if (gl::functions().ARB_polygon_offset_clamp)
        glPolygonOffsetClamp(3.5f, -2, 0.25f);
    else
        glPolygonOffset(3.5f, -2);
}
void bindBuffersEverywhere(Host& host) {
    for (const GLenum target :
         {GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, GL_DRAW_INDIRECT_BUFFER,
          GL_TEXTURE_BUFFER, GL_UNIFORM_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER})
        glBindBuffer(target, host.otherBuffer);
    const auto blocks = static_cast<GLuint>(integer(GL_MAX_UNIFORM_BUFFER_BINDINGS));
    for (GLuint i = 0; i < blocks; ++i)
        if (i % 2)
            glBindBufferBase(GL_UNIFORM_BUFFER, i, host.otherBuffer);
        else
            glBindBufferRange(GL_UNIFORM_BUFFER, i, host.buffer, 256, 512);
    glBindBuffer(GL_UNIFORM_BUFFER, host.buffer);
}
void useObjects(Host& host) {
    glUseProgram(host.program);
    glBindProgramPipeline(host.pipeline);
    glBindVertexArray(host.vertexArray);
    glBindRenderbuffer(GL_RENDERBUFFER, host.renderbuffer);
    for (GLuint i = 0; i < static_cast<GLuint>(integer(GL_MAX_VERTEX_ATTRIBS)); ++i)
        glVertexAttrib4f(i, 1, 2, 3, 4);
}
void bindFramebuffers(Host& host) {
    glBindFramebuffer(GL_FRAMEBUFFER, host.framebuffer);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, host.incomplete);
}
/// In the midst of a capture, of object `object`; its buffer stays bound for it.
template <bool Own, bool Paused>
void capture(Host& host) {
    glBindFramebuffer(GL_FRAMEBUFFER, host.framebuffer);
    glUseProgram(host.program);
    glBindVertexArray(host.vertexArray);
    glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, Own ? host.feedback : 0);
    glBindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, host.otherBuffer, 64, 1024);
    glBeginTransformFeedback(GL_POINTS);
    if (Paused) glPauseTransformFeedback();
}
void measureTime(Host& host) {
    glBeginQuery(GL_TIME_ELAPSED, host.query);
}
void setHints(Host&) {
    for (const GLenum hint : {GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT,
                              GL_TEXTURE_COMPRESSION_HINT, GL_FRAGMENT_SHADER_DERIVATIVE_HINT})
        glHint(hint, GL_NICEST);
    glLineWidth(1);  // others are errors in a forward-compatible context
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_POLYGON_SMOOTH);
}
void excludeWindow(Host&) {
    const GLint box[] = {0, 0, 1000, 1000};
    glWindowRectanglesEXT(GL_EXCLUSIVE_EXT, 1, box);
}

const Setting kSettings[] = {
    {"scissor",
     [](Host&) {
         glEnable(GL_SCISSOR_TEST);
         glScissor(0, 0, 1, 1);
     }},
    {"viewports and depth ranges, scissors of some", moveViewports},
    {"blending", blendStrangely, true},
    {"blending of each draw buffer", blendEachStrangely},
    {"colour mask", [](Host&) { glColorMask(GL_FALSE, GL_FALSE, GL_TRUE, GL_FALSE); }, true},
    {"colour masks of each draw buffer", maskEach},
    {"polygons as lines", [](Host&) { glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); }, true},
    {"polygons as points", [](Host&) { glPolygonMode(GL_FRONT_AND_BACK, GL_POINT); }},
    {"polygon offset", offsetPolygons},
    {"culling",
     [](Host&) {
         glEnable(GL_CULL_FACE);
         glCullFace(GL_FRONT_AND_BACK);
         glFrontFace(GL_CW);
     }},
    {"point size", [](Host&) { glPointSize(5); }},
    {"program point size", enable<GL_PROGRAM_POINT_SIZE>},
    {"point fade and origin",
     [](Host&) {
         glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 60);
         glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT);
     }},
    {"logic operation",
     [](Host&) {
         glEnable(GL_COLOR_LOGIC_OP);
         glLogicOp(GL_INVERT);
     }},
    {"rasterizer discard", enable<GL_RASTERIZER_DISCARD>},
    {"rows packed apart", store<GL_PACK_ROW_LENGTH, 77>},
    {"packed elsewhere",
     [](Host&) {
         glPixelStorei(GL_PACK_SKIP_ROWS, 1);
         glPixelStorei(GL_PACK_SKIP_PIXELS, 2);
         glPixelStorei(GL_PACK_SKIP_IMAGES, 1);
         glPixelStorei(GL_PACK_IMAGE_HEIGHT, 99);
     }},
    {"packed with bytes swapped",
     [](Host&) {
         glPixelStorei(GL_PACK_SWAP_BYTES, GL_TRUE);
         glPixelStorei(GL_PACK_LSB_FIRST, GL_TRUE);
         glPixelStorei(GL_PACK_ALIGNMENT, 1);
     }},
    {"rows unpacked apart", store<GL_UNPACK_ROW_LENGTH, 77>},
    {"unpacked from elsewhere",
     [](Host&) {
         glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);
         glPixelStorei(GL_UNPACK_SKIP_PIXELS, 2);
         glPixelStorei(GL_UNPACK_SKIP_IMAGES, 1);
         glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 99);
     }},
    {"unpacked with bytes swapped",
     [](Host&) {
         glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
         glPixelStorei(GL_UNPACK_LSB_FIRST, GL_TRUE);
         glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
     }},
    {"pack buffer", [](Host& host) { glBindBuffer(GL_PIXEL_PACK_BUFFER, host.buffer); }},
    {"unpack buffer", [](Host& host) { glBindBuffer(GL_PIXEL_UNPACK_BUFFER, host.buffer); }},
    {"clamped reads", [](Host&) { glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE); }},
    {"primitive restart",
     [](Host&) {
         glEnable(GL_PRIMITIVE_RESTART);
         glPrimitiveRestartIndex(0);
     }},
    {"sRGB", enable<GL_FRAMEBUFFER_SRGB>},
    {"no dithering", disable<GL_DITHER>},
    {"no multisampling", disable<GL_MULTISAMPLE>},
    {"samples thinned out", thinSamples},
    {"depth clamp", enable<GL_DEPTH_CLAMP>},
    {"clip distances",
     [](Host&) {
         for (GLenum i = 0; i < 8; ++i) glEnable(GL_CLIP_DISTANCE0 + i);
     }},
    {"depth and stencil", refuseDepthAndStencil},
    {"clear colour", [](Host&) { glClearColor(0.1f, 0.2f, 0.3f, 0.4f); }},
    {"provoking vertex", [](Host&) { glProvokingVertex(GL_FIRST_VERTEX_CONVENTION); }},
    {"patches",
     [](Host&) {
         const GLfloat levels[] = {2, 3, 4, 5};
         glPatchParameteri(GL_PATCH_VERTICES, 7);
         glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, levels);
         glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, levels);
     }},
    {"hints and smooth edges", setHints},
    {"seamless cube maps", enable<GL_TEXTURE_CUBE_MAP_SEAMLESS>},
    {"samplers on every unit", bindSamplers},
    {"images on every unit", bindImages},
    {"textures on every unit", bindEveryUnit},
    {"buffers everywhere", bindBuffersEverywhere},
    {"program, pipeline, vertex array", useObjects},
    {"framebuffers, one of them incomplete", bindFramebuffers, true},
    {"transform feedback object",
     [](Host& host) { glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, host.feedback); }, true},
    {"active transform feedback", capture<true, false>},
    {"active transform feedback of object 0", capture<false, false>, true},
    {"paused transform feedback", capture<true, true>, true},
    {"a query of time", measureTime},
};

const Setting kFixedIndex = {"primitive restart, fixed index", enable<0x8D69>};
const Setting kQueryBuffer = {"query buffer",
                              [](Host& host) { glBindBuffer(GL_QUERY_BUFFER, host.otherBuffer); }};
/// GL_KHR_blend_equation_advanced: GL_MULTIPLY_KHR.
const Setting kAdvancedBlending = {"advanced blending", [](Host&) { glBlendEquation(0x9294); },
                                   true};
const Setting kClipControl = {"clip control",
                              [](Host&) { glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE); }};
const Setting kWindowRectangles = {"window rectangles", excludeWindow};
/// Of extensions that change how OpenGL 4.1 draws.
struct Extra {
    int gl::Functions::*extension;
    Setting setting;
};
const Extra kExtras[] = {
    {&gl::Functions::EXT_depth_bounds_test, {"depth bounds", enable<GL_DEPTH_BOUNDS_TEST_EXT>}},
    {&gl::Functions::NV_conservative_raster,
     {"conservative rasterization", enable<GL_CONSERVATIVE_RASTERIZATION_NV>}},
    {&gl::Functions::INTEL_conservative_rasterization,
     {"conservative rasterization, Intel's", enable<GL_CONSERVATIVE_RASTERIZATION_INTEL>}},
    {&gl::Functions::NV_fragment_coverage_to_color,
     {"coverage to colour", enable<GL_FRAGMENT_COVERAGE_TO_COLOR_NV>}},
    {&gl::Functions::NV_representative_fragment_test,
     {"representative fragments", enable<GL_REPRESENTATIVE_FRAGMENT_TEST_NV>}},
    {&gl::Functions::NV_shading_rate_image, {"shading rate", enable<GL_SHADING_RATE_IMAGE_NV>}},
    {&gl::Functions::NV_scissor_exclusive,
     {"exclusive scissor", [](Host&) { glEnablei(GL_SCISSOR_TEST_EXCLUSIVE_NV, 0); }}},
    {&gl::Functions::NV_viewport_swizzle,
     {"swizzled viewport",
      [](Host&) {
          glViewportSwizzleNV(0, GL_VIEWPORT_SWIZZLE_NEGATIVE_Y_NV,
                              GL_VIEWPORT_SWIZZLE_POSITIVE_X_NV, GL_VIEWPORT_SWIZZLE_NEGATIVE_Z_NV,
                              GL_VIEWPORT_SWIZZLE_POSITIVE_W_NV);
      }}},
};
const Setting kCompatible[] = {
    {"alpha test", enable<kAlphaTest>},
    {"points smooth, no sprites",
     [](Host&) {
         glEnable(kPointSmooth);
         glDisable(kPointSprite);
     }},
    {"large points", [](Host&) { glPointParameterf(kPointSizeMin, 9); }},
    {"polygon stipple", enable<kPolygonStipple>},
    {"clamped fragments", [](Host&) { glClampColor(kClampFragmentColour, GL_TRUE); }},
    {"front and back unlike",
     [](Host&) {
         glPolygonMode(GL_FRONT, GL_LINE);
         glPolygonMode(GL_BACK, GL_POINT);
     },
     true},
};

}  // namespace

std::vector<HostileHost::Setting> HostileHost::settings() const {
    std::vector<Setting> result(std::begin(kSettings), std::end(kSettings));
    gl::Functions& has = gl::functions();
    if (has.ARB_ES3_compatibility) result.push_back(kFixedIndex);
    if (has.ARB_query_buffer_object) result.push_back(kQueryBuffer);
    if (has.ARB_clip_control) result.push_back(kClipControl);
    if (has.EXT_window_rectangles) result.push_back(kWindowRectangles);
    for (int i = 0; i < integer(GL_NUM_EXTENSIONS); ++i)
        if (reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))) ==
            std::string_view("GL_KHR_blend_equation_advanced"))
            result.push_back(kAdvancedBlending);
    for (const Extra& extra : kExtras)
        if (has.*extra.extension) result.push_back(extra.setting);
    if (compatibility) result.insert(result.end(), std::begin(kCompatible), std::end(kCompatible));
    return result;
}

void HostileHost::setAll() {
    for (const Setting& setting : settings())
        if (!setting.alone) setting.set(*this);
}
