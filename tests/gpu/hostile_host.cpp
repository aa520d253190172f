#include "gpu/hostile_host.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

using namespace sunder;

namespace {

// Numbers that the header of GL 4.1 core does not have.
constexpr GLenum kAlphaTest = 0x0BC0, kPointSmooth = 0x0B10, kPointSprite = 0x8861,
                 kPolygonStipple = 0x0B42, kClampFragmentColour = 0x891B, kPointSizeMin = 0x8126,
                 kPointSizeMax = 0x8127;

constexpr GLenum kTargets[11] = {GL_TEXTURE_1D,
                                 GL_TEXTURE_2D,
                                 GL_TEXTURE_3D,
                                 GL_TEXTURE_1D_ARRAY,
                                 GL_TEXTURE_2D_ARRAY,
                                 GL_TEXTURE_RECTANGLE,
                                 GL_TEXTURE_BUFFER,
                                 GL_TEXTURE_CUBE_MAP,
                                 GL_TEXTURE_CUBE_MAP_ARRAY,
                                 GL_TEXTURE_2D_MULTISAMPLE,
                                 GL_TEXTURE_2D_MULTISAMPLE_ARRAY};
constexpr GLsizeiptr kBytes = 4096;
using Host = HostileHost;
using Setting = HostileHost::Setting;

int integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

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

GLuint shader(GLenum stage, const char* text) {
    const GLuint id = glCreateShader(stage);
    glShaderSource(id, 1, &text, nullptr);
    glCompileShader(id);
    return id;
}

}  // namespace

HostileHost::HostileHost() {
    compatibility = (integer(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0;
    std::array<unsigned char, kBytes> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<unsigned char>(37 * i + 11);
    for (GLuint* name : {&buffer, &otherBuffer}) {
        glGenBuffers(1, name);
        glBindBuffer(GL_ARRAY_BUFFER, *name);
        glBufferData(GL_ARRAY_BUFFER, kBytes, bytes.data(), GL_STATIC_DRAW);
    }
    makeTextures();
    glGenSamplers(1, &sampler);
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
    glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);

    glGenVertexArrays(1, &vertexArray);
    glBindVertexArray(vertexArray);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
    for (GLuint i = 0; i < 4; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 32, nullptr);
        glVertexAttribDivisor(i, i);
    }
    glBindVertexArray(0);

    glGenRenderbuffers(1, &renderbuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, 8, 8);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, plain, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                              renderbuffer);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::logic_error("the host's framebuffer is incomplete");
    glGenFramebuffers(1, &incomplete);
    glBindFramebuffer(GL_FRAMEBUFFER, incomplete);

    makeProgram();
    glGenProgramPipelines(1, &pipeline);
    glBindProgramPipeline(pipeline);
    glGenTransformFeedbacks(1, &feedback);
    glGenQueries(1, &query);
    reset();
}

void HostileHost::makeTextures() {
    glGenTextures(11, textures);
    const std::array<unsigned char, 4 * 8 * 8 * 8> texels = [] {
        std::array<unsigned char, 4 * 8 * 8 * 8> result{};
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = static_cast<unsigned char>(101 * i + 3);
        return result;
    }();
    const auto bind = [&](std::size_t i) {
        glBindTexture(kTargets[i], textures[i]);
        return kTargets[i];
    };
    const auto format = GL_RGBA;
    const auto type = GL_UNSIGNED_BYTE;
    glTexImage1D(bind(0), 0, GL_RGBA8, 8, 0, format, type, texels.data());
    glTexImage2D(bind(1), 0, GL_RGBA8, 8, 8, 0, format, type, texels.data());
    glTexImage3D(bind(2), 0, GL_RGBA8, 8, 8, 8, 0, format, type, texels.data());
    glTexImage2D(bind(3), 0, GL_RGBA8, 8, 8, 0, format, type, texels.data());
    glTexImage3D(bind(4), 0, GL_RGBA8, 8, 8, 8, 0, format, type, texels.data());
    glTexImage2D(bind(5), 0, GL_RGBA8, 8, 8, 0, format, type, texels.data());
    glTexBuffer(bind(6), GL_RGBA8, buffer);
    bind(7);
    for (GLenum face = 0; face < 6; ++face)
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, 8, 8, 0, format, type,
                     texels.data());
    glTexImage3D(bind(8), 0, GL_RGBA8, 8, 8, 6, 0, format, type, texels.data());
    glTexImage2DMultisample(bind(9), 4, GL_RGBA8, 8, 8, GL_TRUE);
    glTexImage3DMultisample(bind(10), 4, GL_RGBA8, 8, 8, 2, GL_TRUE);
    glGenTextures(1, &plain);
    glBindTexture(GL_TEXTURE_2D, plain);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, format, type, texels.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
}

void HostileHost::makeProgram() {
    program = glCreateProgram();
    const GLuint vertex = shader(GL_VERTEX_SHADER,
                                 "#version 410 core\nlayout(location = 0) in vec3 at;\n"
                                 "out vec3 seen;\n"
                                 "void main() { seen = 2.0 * at; gl_Position = vec4(at, 1.0); }\n");
    const GLuint fragment = shader(GL_FRAGMENT_SHADER,
                                   "#version 410 core\nout vec4 colour;\n"
                                   "void main() { colour = vec4(1.0); }\n");
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    const char* const varying = "seen";
    glTransformFeedbackVaryings(program, 1, &varying, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) throw std::logic_error("the host's program does not link");
}

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

void HostileHost::reset() {
    GLint timing = 0;
    glGetQueryiv(GL_TIME_ELAPSED, GL_CURRENT_QUERY, &timing);
    if (timing) glEndQuery(GL_TIME_ELAPSED);
    for (const GLuint object : {feedback, 0u}) {
        if (integer(GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE)) glEndTransformFeedback();
        glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, object);
        if (integer(GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE)) glEndTransformFeedback();
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    }
    for (const GLenum capability : {GL_SCISSOR_TEST,        GL_BLEND,
                                    GL_CULL_FACE,           GL_POLYGON_OFFSET_FILL,
                                    GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT,
                                    GL_PROGRAM_POINT_SIZE,  GL_COLOR_LOGIC_OP,
                                    GL_RASTERIZER_DISCARD,  GL_PRIMITIVE_RESTART,
                                    GL_FRAMEBUFFER_SRGB,    GL_SAMPLE_COVERAGE,
                                    GL_SAMPLE_MASK,         GL_SAMPLE_ALPHA_TO_COVERAGE,
                                    GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_SHADING,
                                    GL_DEPTH_CLAMP,         GL_DEPTH_TEST,
                                    GL_STENCIL_TEST,        GL_LINE_SMOOTH,
                                    GL_POLYGON_SMOOTH,      GL_TEXTURE_CUBE_MAP_SEAMLESS,
                                    GL_CLIP_DISTANCE0,      GL_CLIP_DISTANCE1,
                                    GL_CLIP_DISTANCE2,      GL_CLIP_DISTANCE3,
                                    GL_CLIP_DISTANCE4,      GL_CLIP_DISTANCE5,
                                    GL_CLIP_DISTANCE6,      GL_CLIP_DISTANCE7})
        glDisable(capability);
    glEnable(GL_DITHER);
    glEnable(GL_MULTISAMPLE);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDrawBuffer(GL_COLOR_ATTACHMENT0);
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, 10, 10);
    glScissor(0, 0, 10, 10);
    glDepthRange(0, 1);
    glBlendColor(0, 0, 0, 0);
    glBlendFunc(GL_ONE, GL_ZERO);
    glBlendEquation(GL_FUNC_ADD);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glPolygonOffset(0, 0);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glPointSize(1);
    glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 1);
    glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_UPPER_LEFT);
    glLogicOp(GL_COPY);
    for (const GLenum name :
         {GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_PACK_ROW_LENGTH, GL_PACK_IMAGE_HEIGHT,
          GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_IMAGES, GL_UNPACK_SWAP_BYTES,
          GL_UNPACK_LSB_FIRST, GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_ROWS,
          GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_IMAGES})
        glPixelStorei(name, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    for (const GLenum target : {GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER, GL_ARRAY_BUFFER,
                                GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, GL_DRAW_INDIRECT_BUFFER,
                                GL_TEXTURE_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER})
        glBindBuffer(target, 0);
    const auto blocks = static_cast<GLuint>(integer(GL_MAX_UNIFORM_BUFFER_BINDINGS));
    for (GLuint i = 0; i < blocks; ++i) glBindBufferBase(GL_UNIFORM_BUFFER, i, 0);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY);
    glPrimitiveRestartIndex(0);
    glSampleCoverage(1, GL_FALSE);
    glSampleMaski(0, 0xFFFFFFFFu);
    glMinSampleShading(0);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glClearDepth(1);
    glStencilFunc(GL_ALWAYS, 0, 0xFFFFFFFFu);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    glStencilMask(0xFFFFFFFFu);
    glClearStencil(0);
    glClearColor(0, 0, 0, 0);
    glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    const GLfloat ones[] = {1, 1, 1, 1};
    glPatchParameteri(GL_PATCH_VERTICES, 3);
    glPatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, ones);
    glPatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, ones);
    for (const GLenum hint : {GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT,
                              GL_TEXTURE_COMPRESSION_HINT, GL_FRAGMENT_SHADER_DERIVATIVE_HINT})
        glHint(hint, GL_DONT_CARE);
    for (int unit = integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS) - 1; unit >= 0; --unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (const GLenum target : kTargets) glBindTexture(target, 0);
        glBindSampler(static_cast<GLuint>(unit), 0);
    }
    glUseProgram(0);
    glBindProgramPipeline(0);
    glBindVertexArray(0);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    for (GLuint i = 0; i < static_cast<GLuint>(integer(GL_MAX_VERTEX_ATTRIBS)); ++i)
        glVertexAttrib4f(i, 0, 0, 0, 1);
    gl::Functions& has = gl::functions();
    if (has.ARB_ES3_compatibility) glDisable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
    if (has.ARB_query_buffer_object) glBindBuffer(GL_QUERY_BUFFER, 0);
    if (has.ARB_clip_control) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    if (has.EXT_window_rectangles) glWindowRectanglesEXT(GL_EXCLUSIVE_EXT, 0, nullptr);
    const std::pair<int, GLenum> extras[] = {
        {has.EXT_depth_bounds_test, GL_DEPTH_BOUNDS_TEST_EXT},
        {has.NV_conservative_raster, GL_CONSERVATIVE_RASTERIZATION_NV},
        {has.INTEL_conservative_rasterization, GL_CONSERVATIVE_RASTERIZATION_INTEL},
        {has.NV_fragment_coverage_to_color, GL_FRAGMENT_COVERAGE_TO_COLOR_NV},
        {has.NV_representative_fragment_test, GL_REPRESENTATIVE_FRAGMENT_TEST_NV},
        {has.NV_shading_rate_image, GL_SHADING_RATE_IMAGE_NV}};
    for (const auto& [there, capability] : extras)
        if (there) glDisable(capability);
    if (has.NV_scissor_exclusive) glDisablei(GL_SCISSOR_TEST_EXCLUSIVE_NV, 0);
    if (has.NV_viewport_swizzle)
        glViewportSwizzleNV(0, GL_VIEWPORT_SWIZZLE_POSITIVE_X_NV, GL_VIEWPORT_SWIZZLE_POSITIVE_Y_NV,
                            GL_VIEWPORT_SWIZZLE_POSITIVE_Z_NV, GL_VIEWPORT_SWIZZLE_POSITIVE_W_NV);
    if (!compatibility) return;
    for (const GLenum capability : {kAlphaTest, kPointSmooth, kPolygonStipple})
        glDisable(capability);
    glEnable(kPointSprite);
    glPointParameterf(kPointSizeMin, 0);
    glClampColor(kClampFragmentColour, GL_FIXED_ONLY);
}

std::uint64_t HostileHost::contents() {
    std::uint64_t sum = 0xcbf29ce484222325u;
    const auto add = [&](const std::array<unsigned char, kBytes>& bytes) {
        for (const unsigned char byte : bytes) sum = (sum ^ byte) * 0x100000001b3u;
    };
    std::array<unsigned char, kBytes> bytes{};
    for (const GLuint name : {buffer, otherBuffer}) {
        glBindBuffer(GL_COPY_READ_BUFFER, name);
        glGetBufferSubData(GL_COPY_READ_BUFFER, 0, kBytes, bytes.data());
        add(bytes);
    }
    for (const std::size_t i : {0u, 1u, 2u, 3u, 4u, 5u}) {
        glBindTexture(kTargets[i], textures[i]);
        glGetTexImage(kTargets[i], 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        add(bytes);
    }
    glBindTexture(GL_TEXTURE_2D, plain);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    add(bytes);
    for (const GLenum target : kTargets) glBindTexture(target, 0);
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    return sum;
}
