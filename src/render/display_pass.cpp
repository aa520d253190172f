#include "render/display_pass.hpp"

#include "gl/vertex_array.hpp"
#include "render/shading.hpp"
#include "render/uniforms.hpp"

namespace sunder::render {
namespace {

gl::ProgramDescription describe(DisplayPass::Output output, bool turned) {
    using Output = DisplayPass::Output;
    gl::ProgramDescription description{.vertex = "draw/display.vert"};
    switch (output) {
        case Output::Depth:
            description.defines = {{"DEPTH_ONLY", "1"}};
            break;
        case Output::Shaded:
            description.fragment = "draw/display.frag";
            break;
        case Output::Lines:
            description.fragment = "draw/display_lines.frag";
            break;
        case Output::Veil:
            description.fragment = "draw/veil.frag";
            description.defines = {{"DEPTH_ONLY", "1"}};
            break;
        case Output::Transparent:
            description.fragment = "draw/display.frag";
            description.defines = {{"TRANSPARENT", "1"}};
            break;
        case Output::Captured:
            description.feedback = {"position", "normal", "place"};
            break;
    }
    description.defines = gpu::withTurned(std::move(description.defines), turned);
    return description;
}

}  // namespace

DisplayBuffers::DisplayBuffers(const surface::DisplayMesh& mesh)
    : vertices_(mesh.vertices().size()),
      indices_(mesh.indices().size()),
      opaqueIndices_(mesh.opaqueIndices()),
      vertexBuffer_(gl::makeBuffer(std::span(mesh.vertices()), GL_STATIC_DRAW, "display mesh")),
      indexBuffer_(gl::makeBuffer(std::span(mesh.indices()), GL_STATIC_DRAW, "display mesh")),
      vertexArray_(
          gl::makeVertexArray({{vertexBuffer_,
                                sizeof(surface::DisplayVertex),
                                {{0, 3, GL_FLOAT, offsetof(surface::DisplayVertex, rest)},
                                 {1, 3, GL_UNSIGNED_INT, offsetof(surface::DisplayVertex, cell)}}}},
                              &indexBuffer_)) {}

void DisplayBuffers::draw(Part part) const {
    const std::size_t first = part == Part::Opaque ? 0 : opaqueIndices_;
    glBindVertexArray(vertexArray_.id());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count(part)), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

void DisplayBuffers::drawVertices() const {
    glBindVertexArray(vertexArray_.id());
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(vertices_));
}

DisplayPass::DisplayPass(Output output, const gpu::WorldBuffers& buffers,
                         const DisplayBuffers& mesh)
    : buffers_(buffers), mesh_(mesh), program_(describe(output, buffers.turned())) {
    gpu::prepareWallState(program_, kWallUnit);
    Shading::prepare(program_);
}

const gl::Program& DisplayPass::begin() const {
    program_.use();
    return program_;
}

void DisplayPass::draw(const gpu::StateView& state, const glm::mat4& viewProjection,
                       DisplayBuffers::Part part) const {
    setUniform(program_, "viewProjection", viewProjection);
    gpu::bindWallState(program_, buffers_, state, kWallUnit);
    mesh_.draw(part);
}

void DisplayPass::drawVertices(const gpu::StateView& state) const {
    gpu::bindWallState(program_, buffers_, state, kWallUnit);
    mesh_.drawVertices();
}

}  // namespace sunder::render
