#include "gpu/hostile_host.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>

using namespace sunder;
using namespace hostile;

namespace {

constexpr GLsizeiptr kBytes = 4096;
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
    if (glBindImageTexture)
        for (int unit = 0; unit < integer(GL_MAX_IMAGE_UNITS); ++unit)
            glBindImageTexture(static_cast<GLuint>(unit), 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R8);
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
