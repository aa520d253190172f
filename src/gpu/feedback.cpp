#include "gpu/feedback.hpp"

#include <bit>

#include "gpu/layout.hpp"

namespace sunder::gpu {

using namespace core;

namespace {

constexpr const char* kSamplers[kUnitCount] = {
    "cells",        "bodies",        "rest",         "nodes",      "bonds",
    "events",       "links",         "forces",       "stresses",   "cumulativeForces",
    "strengths",    "rectangles",    "chunks",       "records",    "spheres",
    "regions",      "exposed",       "grid",         "partners",   "summaries",
    "hastes",       "freeMotions",   "sphereForces", "objects",    "motion",
    "sleepers",     "touchCounts",   "impulses",     "knownBonds", "pushes",
    "pushesBefore", "pushesEarlier", "partings",     "released",   "cellGroups"};
constexpr int kLawBinding = 0;

}  // namespace

void setConstants(const gl::Program& program, const World& world, int textureColumns) {
    program.bindUniformBlock("ElementLaws", kLawBinding);
    for (int unit = 0; unit < kUnitCount; ++unit) program.bindSampler(kSamplers[unit], unit);
    glUniform1i(program.uniform("textureShift"),
                std::countr_zero(static_cast<unsigned>(textureColumns)));
    const auto h = static_cast<float>(world.step());
    glUniform1f(program.uniform("stepSize"), h);
    glUniform1f(program.uniform("interval"), static_cast<float>(world.fractureInterval()) * h);
    glUniform1f(program.uniform("fastestParting"),
                static_cast<float>(world.description().partingSpeed));
    glUniform1i(program.uniform("partingCount"), static_cast<int>(world.partings().size()));
    glUniform2f(program.uniform("ground"), world.description().ground ? 1.0f : 0.0f,
                static_cast<float>(world.description().groundFriction));
    if (const auto& room = world.description().room) {
        const double nowhere = SUNDER_NO_BARRIER;
        const auto setPlace = [&](const char* name, double x, double y, double z) {
            glUniform3f(program.uniform(name), static_cast<float>(x), static_cast<float>(y),
                        static_cast<float>(z));
        };
        setPlace("roomLow", room->x[0], -nowhere, room->z[0]);
        setPlace("roomHigh", room->x[1], room->ceiling.value_or(nowhere), room->z[1]);
        glUniform1f(program.uniform("roomFriction"), static_cast<float>(room->friction));
    }
}

void bindWorld(const WorldBuffers& buffers) {
    gl::bindTexture(kCells, GL_TEXTURE_BUFFER, buffers.cells());
    gl::bindTexture(kBodies, GL_TEXTURE_BUFFER, buffers.bodies());
    gl::bindTexture(kRest, GL_TEXTURE_BUFFER, buffers.rest());
    gl::bindTexture(kStrengths, GL_TEXTURE_BUFFER, buffers.strengths());
    gl::bindTexture(kPartings, GL_TEXTURE_BUFFER, buffers.partings());
    gl::bindUniforms(kLawBinding, buffers.laws());
}

gl::Framebuffer makeTarget(std::initializer_list<const gl::Texture*> textures) {
    gl::Framebuffer framebuffer = gl::makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    GLenum attachment = GL_COLOR_ATTACHMENT0;
    for (const gl::Texture* texture : textures)
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment++, GL_TEXTURE_2D, texture->id(), 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw DeviceError("the driver cannot draw into the textures a solver needs");
    return framebuffer;
}

Feedback::Feedback()
    : texture_(gl::makeTexture2D(1, 1, GL_RGBA8, "discarded texels")),
      target_(makeTarget({&texture_})),
      capture_(gl::makeTransformFeedback()),
      noAttributes_(gl::makeVertexArray()) {}

void Feedback::run(const gl::Program& program, std::initializer_list<const gl::Buffer*> targets,
                   int count) const {
    run(program, noAttributes_, targets, count);
}

void Feedback::run(const gl::Program& program, const gl::VertexArray& attributes,
                   std::initializer_list<const gl::Buffer*> targets, int count) const {
    const auto bind = [&] {
        GLuint index = 0;
        for (const gl::Buffer* target : targets)
            glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, index++, target->id());
    };
    capture(program, attributes, bind, static_cast<int>(targets.size()), 0, count);
}

void Feedback::runPart(const gl::Program& program, const gl::VertexArray& attributes,
                       const gl::Buffer& target, std::size_t stride, int first, int count) const {
    const auto bytes = [&](int vertices) {
        return static_cast<GLintptr>(stride) * static_cast<GLintptr>(vertices);
    };
    const auto bind = [&] {
        glBindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, target.id(), bytes(first), bytes(count));
    };
    capture(program, attributes, bind, 1, first, count);
}

template <class Bind>
void Feedback::capture(const gl::Program& program, const gl::VertexArray& attributes,
                       const Bind& bind, int targets, int first, int count) const {
    // Nothing is rasterised, but without a complete framebuffer the draw would fail and capture
    // nothing.
    glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
    glEnable(GL_RASTERIZER_DISCARD);
    program.use();
    glBindVertexArray(attributes.id());
    gl::beginCaptures(capture_);
    bind();
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, first, count);
    glEndTransformFeedback();
    for (GLuint index = 0; index < static_cast<GLuint>(targets); ++index)
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, index, 0);
    gl::endCaptures();
    glDisable(GL_RASTERIZER_DISCARD);
}

}  // namespace sunder::gpu
