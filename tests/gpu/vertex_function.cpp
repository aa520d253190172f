#include "gpu/vertex_function.hpp"

#include <sstream>

#include "gl/program.hpp"
#include "gpu/test_context.hpp"

using namespace sunder;

std::vector<float> VertexFunction::run(std::span<const float> input, int count) const {
    window::Context& context = testContext();
    std::string text;
    std::istringstream list(includes);
    for (std::string name; list >> name;) text += "#include \"" + name + "\"\n";
    text += "uniform samplerBuffer items;\n" + outputs +
            "\nvec4 item(int i) { return texelFetch(items, " + std::to_string(itemTexels) +
            " * gl_VertexID + i); }\nvoid main() {\n" + body + "\n}\n";

    gl::ProgramDescription description{.vertex = "test.vert", .feedback = names};
    description.source = [&](std::string_view name) {
        return name == "test.vert" ? std::optional(text) : gl::embeddedShaders()(name);
    };
    const gl::Program program(description);
    const gl::Buffer in = gl::makeBuffer<float>(input, GL_STATIC_DRAW, "test input");
    const gl::Texture texture = gl::makeBufferTexture(in, GL_RGBA32F, "test input");
    const gl::Buffer out(sizeof(float) * resultFloats * count, nullptr, GL_DYNAMIC_COPY,
                         "test output");
    const gl::Texture pixel = gl::makeTexture2D(1, 1, GL_RGBA8, "test target");
    const gl::Framebuffer framebuffer = gl::makeFramebuffer();
    const gl::VertexArray attributes = gl::makeVertexArray();

    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, pixel.id(), 0);
    glEnable(GL_RASTERIZER_DISCARD);
    program.bindSampler("items", 0);
    gl::bindTexture(0, GL_TEXTURE_BUFFER, texture);
    glBindVertexArray(attributes.id());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, out.id());
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, count);
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);

    std::vector<float> result(std::size_t(resultFloats) * count);
    out.read(0, sizeof(float) * result.size(), result.data());
    context.check();
    return result;
}
