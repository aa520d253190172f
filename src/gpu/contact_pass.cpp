#include "gpu/contact_pass.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/contact.hpp"
#include "gpu/feedback.hpp"

namespace sunder::gpu {
namespace {

/// Two texels per cell or more.
int gridTexels(const World& world) {
    return static_cast<int>(std::bit_ceil(2 * static_cast<unsigned>(world.cellCount())));
}

/// Spheres that are a voxel apart or more are out of the margin of those that do not close in
/// faster. The smaller the voxels, the fewer cells share an eighth of one.
double voxelSize(const World& world) {
    double reach = 0, radius = 0;
    for (const Body& body : world.bodies()) {
        const ContactProxy proxy = contactProxy(body.cellSize);
        reach = std::max(reach, proxy.reach(body.cellSize));
        radius = std::max(radius, proxy.radius);
    }
    return 2 * reach + radius;
}

void setGrid(const gl::Program& program, const World& world, int columns) {
    program.use();
    const int columnBits = std::countr_zero(static_cast<unsigned>(columns));
    const int bits = std::countr_zero(static_cast<unsigned>(gridTexels(world)));
    glUniform2i(program.uniform("gridBits"), columnBits, std::max(0, bits - columnBits));
    glUniform1f(program.uniform("voxelSize"), static_cast<float>(voxelSize(world)));
}

}  // namespace

void ContactPass::check(const World& world) {
    for (const Body& body : world.bodies())
        if (contactProxy(body.cellSize).spheres() > 1)
            throw InputError("body '" + body.name +
                             "': the solver gather has contact only between cells whose longest "
                             "edge is less than 1.5 times the shortest; use cpu or reference, or "
                             "leave [contact] out");
}

ContactPass::ContactPass(const World& world, int columns)
    : centres_(world.cellCount(), columns, 2, "cell centres"),
      grid_(gridTexels(world), texelColumns(gridTexels(world)), 6, "contact grid"),
      partners_(world.cellCount(), columns, 6, "contact partners"),
      centreProgram_(centres_.program(world, "contact/centre.frag")),
      insertProgram_({.vertex = "contact/insert.vert", .fragment = "contact/insert.frag"}),
      searchProgram_(partners_.program(world, "contact/search.frag")),
      pushProgram_(partners_.program(world, "contact/push.frag")),
      noAttributes_(gl::makeVertexArray()) {
    setConstants(insertProgram_, world, columns);
    for (const gl::Program* program : {&insertProgram_, &searchProgram_})
        setGrid(*program, world, texelColumns(gridTexels(world)));
    searchProgram_.use();
    glUniform1f(searchProgram_.uniform("searchInterval"),
                static_cast<float>(kContactInterval * world.step()));
}

void ContactPass::search(const TexelRanges& awake, std::span<const TexelRange> held,
                         PassTimer* timer) {
    {
        const TimedPass timed(timer, "contact centres");
        centres_.fill(centreProgram_, awake);
    }
    gl::bindTexture(kCentres, GL_TEXTURE_2D_ARRAY, centres_.texture());
    {
        const TimedPass timed(timer, "contact grid");
        fillGrid(held);
    }
    gl::bindTexture(kGrid, GL_TEXTURE_2D_ARRAY, grid_.texture());
    const TimedPass timed(timer, "contact search");
    partners_.fill(searchProgram_, awake);
}

void ContactPass::fillGrid(std::span<const TexelRange> held) {
    grid_.bind();
    constexpr GLfloat nobody[] = {3e7f, 3e7f, 3e7f, 3e7f}, zero[] = {0, 0, 0, 0};
    for (GLuint layer = 0; layer < 6; ++layer) {
        const bool smallest = layer / 2 == 1;
        glClearBufferfv(GL_COLOR, static_cast<GLint>(layer), smallest ? nobody : zero);
        glBlendEquationi(layer, layer < 2 ? GL_MAX : smallest ? GL_MIN : GL_FUNC_ADD);
    }
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    insertProgram_.use();
    glBindVertexArray(noAttributes_.id());
    for (const TexelRange& range : held)
        glDrawArrays(GL_POINTS, range.first, range.end - range.first);
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
}

void ContactPass::push(const TexelTarget& forces, const TexelRanges& awake) const {
    gl::bindTexture(kPartners, GL_TEXTURE_2D_ARRAY, partners_.texture());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    forces.fill(pushProgram_, awake);
    glDisable(GL_BLEND);
}

}  // namespace sunder::gpu
