#include "gpu/cell_pass.hpp"

#include <algorithm>
#include <array>

#include "gl/driver.hpp"
#include "gpu/feedback.hpp"

namespace sunder::gpu {

using namespace core;

namespace {

constexpr int kTargetImage = 0;  ///< image unit

}  // namespace

CellSet::CellSet(Stage stage, std::size_t most, const char* what)
    : stage_(stage), rectangles_(most, what) {}

void CellSet::set(std::span<const TexelRange> ranges, int columns) {
    rectangles_.set(ranges, columns);
    if (stage_ == Stage::Fragment) return;
    std::vector<std::array<GLint, 2>> groups;
    for (const TexelRange& range : ranges)
        for (int first = range.first; first < range.end; first += SUNDER_CELL_GROUP)
            groups.push_back({first, std::min(SUNDER_CELL_GROUP, range.end - first)});
    groups_ = static_cast<int>(groups.size());
    const std::size_t bytes = sizeof groups[0] * groups.size();
    if (groupBuffer_.size() < bytes) {
        groupBuffer_ = gl::Buffer(2 * bytes, nullptr, GL_DYNAMIC_DRAW, "cell groups");
        groupTexture_ = gl::makeBufferTexture(groupBuffer_, GL_RG32I, "cell groups");
    }
    if (bytes > 0) groupBuffer_.write(0, bytes, groups.data());
}

CellPass::CellPass(Stage stage, const TexelTarget& target, const World& world, const char* file,
                   gl::Defines defines, int invocations)
    : stage_(stage), invocations_(invocations) {
    if (stage == Stage::Fragment) {
        program_ = target.program(world, file, std::move(defines));
        return;
    }
    program_ = gl::Program(
        {.compute = file,
         .defines = withTurned(gl::with(std::move(defines), "COMPUTE", "1"), world.anyTurned())});
    setConstants(program_, world, target.columns());
    glUniform1i(program_.uniform("target"), kTargetImage);
}

void CellPass::run(const TexelTarget& to, const CellSet& cells, int part) const {
    if (stage_ == Stage::Fragment) return to.fill(program_, cells.rectangles(), part);
    if (cells.empty()) return;
    gl::bindImage(kTargetImage, to.texture());
    gl::bindTexture(kCellGroups, GL_TEXTURE_BUFFER, cells.groupTexture());
    program_.use();
    glDispatchCompute(static_cast<GLuint>(cells.groups()), static_cast<GLuint>(invocations_), 1);
    finishImages();
}

void finishImages() {
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                    GL_PIXEL_BUFFER_BARRIER_BIT);
}

void requireCompute() {
    const int major = gl::limit(GL_MAJOR_VERSION), minor = gl::limit(GL_MINOR_VERSION);
    const gl::Functions& functions = gl::Driver::current()->functions();
    if (10 * major + minor >= 43 && functions.DispatchCompute && functions.BindImageTexture &&
        functions.MemoryBarrier)
        return;
    throw InputError("the solver compute needs OpenGL 4.3, and this context has " +
                     std::to_string(major) + "." + std::to_string(minor) +
                     "; use the solver gather");
}

}  // namespace sunder::gpu
