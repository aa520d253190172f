#include "gpu/contact_pass.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/constants.hpp"
#include "core/contact.hpp"
#include "gpu/feedback.hpp"

namespace sunder::gpu {

using namespace core;

namespace {

/// Numbers of spheres are floats in textures; those of objects come after
/// (glsl/incidents/rank.glsl).
constexpr std::int64_t kMostSpheres = (1 << 24) - 2 - kMaxObjects;

int countSpheres(const World& world) {
    const std::int64_t count = std::int64_t{world.cellCount()} << ContactPass::sphereBits(world);
    if (count > kMostSpheres)
        throw InputError("the world is too large for contact on the GPU: it would have " +
                         std::to_string(count) + " spheres, " + std::to_string(kMostSpheres) +
                         " are the limit; use fewer cells, the solver cpu, or leave [contact] out");
    return static_cast<int>(count);
}

double largestRadius(const World& world) {
    double radius = 0;
    for (const Body& body : world.bodies())
        radius = std::max(radius, contactProxy(body.cellSize).radius);
    return radius;
}

/// m: how far apart centres of spheres may be to get on a list; those that close in faster than a
/// diameter per two searches would have to be there sooner.
double reach(const World& world) {
    return 3 * largestRadius(world);
}

/// Few voxels share a texel.
int gridTexels(const World& world) {
    return static_cast<int>(std::bit_ceil(4 * static_cast<unsigned>(countSpheres(world))));
}
int regionTexels(const World& world) {
    return static_cast<int>(std::bit_ceil(2 * static_cast<unsigned>(countSpheres(world))));
}

/// Columns and rows of a texture for that many texels, as powers of two.
void setBits(const gl::Program& program, const char* name, int texels) {
    const int columnBits = std::countr_zero(static_cast<unsigned>(texelColumns(texels)));
    const int bits = std::countr_zero(static_cast<unsigned>(texels));
    program.use();
    glUniform2i(program.uniform(name), columnBits, std::max(0, bits - columnBits));
}

void setGrid(const gl::Program& program, const World& world) {
    setBits(program, "gridBits", gridTexels(world));
    glUniform1f(program.uniform("voxelsPerMetre"),
                static_cast<float>(1 / (2 * largestRadius(world))));
}

/// Regions are numbered along x, y, z through the box that the bodies start in, with some room
/// around.
void setRegions(const gl::Program& program, const World& world) {
    const double size = 2.01 * reach(world);
    Vec3 low = Vec3::Constant(1e30), high = -low;
    for (const Body& body : world.bodies()) {
        const Box box = body.bounds();
        low = low.cwiseMin(box.low);
        high = high.cwiseMax(box.high);
    }
    const auto extent = [&](int axis) {
        return static_cast<int>(std::min((high[axis] - low[axis]) / size, 30000.0)) + 8;
    };
    setBits(program, "regionBits", regionTexels(world));
    glUniform3i(program.uniform("regionStrides"), 1, extent(0), extent(0) * extent(1));
    glUniform1f(program.uniform("regionSize"), static_cast<float>(size));
}

/// While it lives, nothing is drawn or cleared where the query found nothing: the GPU decides, and
/// nobody waits.
class WhereAny {
  public:
    explicit WhereAny(const gl::Query& query) {
        glBeginConditionalRender(query.id(), GL_QUERY_WAIT);
    }
    ~WhereAny() { glEndConditionalRender(); }
    WhereAny(const WhereAny&) = delete;
    WhereAny& operator=(const WhereAny&) = delete;
};

}  // namespace

int ContactPass::sphereBits(const World& world) {
    unsigned most = 1;
    for (const Body& body : world.bodies())
        most = std::max(most, static_cast<unsigned>(contactProxy(body.cellSize).spheres()));
    return std::bit_width(most - 1);
}

ContactPass::ContactPass(const World& world, int columns, Storage storage)
    : world_(world),
      columns_(columns),
      sphereBits_(sphereBits(world)),
      defines_{{"SPHERE_BITS", std::to_string(sphereBits_)},
               {"BUFFERS", storage == Storage::Buffers ? "1" : "0"},
               {"PARTINGS", world.partings().empty() ? "0" : "1"},
               {"UNEQUAL", world.unequalCells() ? "1" : "0"}},
      spheres_(countSpheres(world), columns << sphereBits_, 2, "contact spheres"),
      regions_(regionTexels(world), texelColumns(regionTexels(world)), 2, "contact regions"),
      exposed_(countSpheres(world), columns << sphereBits_, 1, "exposed spheres"),
      grid_(gridTexels(world), texelColumns(gridTexels(world)), 3, "contact grid"),
      partners_(countSpheres(world), columns << sphereBits_, kPartnerLayers, "contact partners"),
      hastes_(world.cellCount(), columns, 1, "contact haste"),
      sphereProgram_(program(spheres_, "contact/spheres.frag", gl::with(defines_, "LISTED", "0"))),
      listedProgram_(program(spheres_, "contact/spheres.frag", gl::with(defines_, "LISTED", "1"))),
      regionProgram_({.vertex = "contact/region.vert",
                      .fragment = "contact/region.frag",
                      .defines = withTurned(defines_, world.anyTurned())}),
      exposedProgram_(program(exposed_, "contact/exposed.frag", defines_)),
      gridProgram_(
          {.vertex = "contact/grid.vert", .fragment = "contact/grid.frag", .defines = defines_}),
      searchProgram_(program(partners_, "contact/search.frag", defines_)),
      hasteProgram_(hastes_.program(world, "contact/haste.frag")),
      noAttributes_(gl::makeVertexArray()),
      anyExposed_(gl::makeQuery()),
      awakeSpheres_(world.bodies().size(), "awake spheres"),
      heldSpheres_(world.bodies().size(), "held spheres"),
      awakeCells_(world.bodies().size(), "awake cells") {
    const bool atOnce = sphereBits_ == 0 && storage == Storage::Textures;
    if (!atOnce) sphereForces_.emplace(countSpheres(world), columns << sphereBits_, 1, "pushes");
    pushProgram_ =
        program(partners_, "contact/push.frag",
                gl::with(gl::with(defines_, "IMPULSES", "0"), "CORNERS", atOnce ? "1" : "0"));
    if (sphereBits_ > 0) {
        summaries_.emplace(world.cellCount(), columns, 1, "contact summaries");
        summaryProgram_ = summaries_->program(world, "contact/summary.frag", defines_);
        cornerProgram_ = summaries_->program(world, "contact/corners.frag", defines_);
    }
    if (world.unequalCells()) {
        free_.emplace(countSpheres(world), columns << sphereBits_, 1, "free motions");
        freeProgram_ = program(*free_, "contact/free.frag", defines_);
    }
    forgetHaste();
    partners_.bind();
    constexpr GLfloat zero[] = {0, 0, 0, 0};
    for (GLint layer = 0; layer < kPartnerLayers; ++layer) glClearBufferfv(GL_COLOR, layer, zero);
    for (const gl::Program* program : {&regionProgram_, &gridProgram_})
        setConstants(*program, world, columns);
    for (const gl::Program* program : {&regionProgram_, &exposedProgram_})
        setRegions(*program, world);
    for (const gl::Program* program : {&gridProgram_, &searchProgram_}) setGrid(*program, world);
    searchProgram_.use();
    glUniform1f(searchProgram_.uniform("reach"), static_cast<float>(reach(world)));
    glUniform1f(searchProgram_.uniform("searchInterval"), static_cast<float>(world.contactTime()));
}

/// One that fills a target of spheres, and knows the columns of what has a texel per cell.
gl::Program ContactPass::program(const TexelTarget& target, const char* fragment,
                                 gl::Defines defines) const {
    gl::Program program = target.program(world_, fragment, std::move(defines));
    setConstants(program, world_, columns_);
    return program;
}

void ContactPass::setCells(std::span<const TexelRange> awake, std::span<const TexelRange> held) {
    const auto spheresOf = [&](std::span<const TexelRange> cells) {
        std::vector<TexelRange> spheres;
        for (const TexelRange& range : cells)
            spheres.push_back({range.first << sphereBits_, range.end << sphereBits_});
        return spheres;
    };
    held_ = spheresOf(held);
    heldSpheres_.set(held_, columns_ << sphereBits_);
    awakeSpheres_.set(spheresOf(awake), columns_ << sphereBits_);
    awakeCells_.set(awake, columns_);
    due_ = true;
}

void ContactPass::update(std::int64_t step, PassTimer* timer) {
    gl::bindTexture(kSpheres, GL_TEXTURE_2D_ARRAY, spheres_.texture());
    gl::bindTexture(kPartners, GL_TEXTURE_2D_ARRAY, partners_.texture());
    gl::bindTexture(kSummaries, GL_TEXTURE_2D_ARRAY, summaries());
    if (due_ || step % world_.contactInterval() == 0) {
        search(step, timer);
        due_ = false;
    } else {
        const TimedPass timed(timer, "contact followed");
        const WhereAny where(anyExposed_);
        spheres_.fill(listedProgram_, awakeSpheres_);
    }
    if (free_) findFreeMotions(timer);
}

/// Bodies that sleep do not move, whatever pushes them.
void ContactPass::findFreeMotions(PassTimer* timer) {
    const TimedPass timed(timer, "contact free motions");
    free_->bind();
    constexpr GLfloat zero[] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, zero);
    const WhereAny where(anyExposed_);
    free_->fill(freeProgram_, awakeSpheres_);
    gl::bindTexture(kFreeMotions, GL_TEXTURE_2D_ARRAY, free_->texture());
}

void ContactPass::search(std::int64_t step, PassTimer* timer) {
    {
        const TimedPass timed(timer, "contact spheres");
        spheres_.fill(sphereProgram_, due_ ? heldSpheres_ : awakeSpheres_);
    }
    {
        const TimedPass timed(timer, "contact regions");
        fillRegions();
    }
    {
        const TimedPass timed(timer, "contact exposed");
        findExposed();
    }
    {
        const TimedPass timed(timer, "contact grid");
        const WhereAny where(anyExposed_);
        shiftGrid(step);
        fillGrid();
    }
    const TimedPass timed(timer, "contact search");
    gl::bindTexture(kGrid, GL_TEXTURE_2D_ARRAY, grid_.texture());
    partners_.fill(searchProgram_, awakeSpheres_);
    if (summaries_) summaries_->fill(summaryProgram_, awakeCells_);
    keepHaste();
}

/// Voxels begin somewhere else in every search, evenly spread.
void ContactPass::shiftGrid(std::int64_t step) {
    const auto turn = [&](double share) {
        return static_cast<float>(std::fmod(static_cast<double>(step) * share, 1.0));
    };
    // Roberts, "The unreasonable effectiveness of quasirandom sequences": powers of 1/1.2207.
    for (const gl::Program* program : {&gridProgram_, &searchProgram_}) {
        program->use();
        glUniform3f(program->uniform("gridShift"), turn(0.8191725134), turn(0.6710436067),
                    turn(0.5497004779));
    }
}

/// A point for each sphere of a held cell.
void ContactPass::drawHeld(const gl::Program& program) const {
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    program.use();
    glBindVertexArray(noAttributes_.id());
    for (const TexelRange& range : held_)
        glDrawArrays(GL_POINTS, range.first, range.end - range.first);
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
}

void ContactPass::fillRegions() {
    regions_.bind();
    constexpr GLfloat nothing[] = {-1e30f, -1e30f, -1e30f, -1e30f};
    for (const GLint layer : {0, 1}) glClearBufferfv(GL_COLOR, layer, nothing);
    glBlendEquation(GL_MAX);
    drawHeld(regionProgram_);
}

void ContactPass::findExposed() {
    gl::bindTexture(kRegions, GL_TEXTURE_2D_ARRAY, regions_.texture());
    exposed_.bind();
    constexpr GLfloat zero[] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, zero);
    glBeginQuery(GL_ANY_SAMPLES_PASSED, anyExposed_.id());
    exposed_.fill(exposedProgram_, heldSpheres_);
    glEndQuery(GL_ANY_SAMPLES_PASSED);
    gl::bindTexture(kExposed, GL_TEXTURE_2D_ARRAY, exposed_.texture());
}

void ContactPass::fillGrid() {
    grid_.bind();
    constexpr GLfloat zero[] = {0, 0, 0, 0};
    for (const GLint layer : {0, 1, 2}) glClearBufferfv(GL_COLOR, layer, zero);
    glBlendEquationSeparate(GL_MAX, GL_FUNC_ADD);
    drawHeld(gridProgram_);
}

void ContactPass::push(const TexelTarget& corners) {
    if (sphereForces_) push();
    const WhereAny where(anyExposed_);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    corners.fill(sphereForces_ ? cornerProgram_ : pushProgram_, awakeCells_);
    glDisable(GL_BLEND);
}

void ContactPass::push() {
    const WhereAny where(anyExposed_);
    sphereForces_->fill(pushProgram_, awakeSpheres_);
    gl::bindTexture(kSphereForces, GL_TEXTURE_2D_ARRAY, sphereForces_->texture());
}

TexelTarget ContactPass::sphereTarget(const char* what) const {
    return {countSpheres(world_), columns_ << sphereBits_, 1, what};
}

void ContactPass::fillAwake(const TexelTarget& target, const gl::Program& program) const {
    const WhereAny where(anyExposed_);
    target.fill(program, awakeSpheres_);
}

std::int64_t ContactPass::dropped() const {
    std::int64_t sum = 0;
    for (const vec4& found :
         (summaries_ ? *summaries_ : partners_).read(0, {0, world_.cellCount()}))
        sum += std::llround(found.z) % kHasteUnit;
    return sum;
}

void ContactPass::keepHaste() const {
    const WhereAny where(anyExposed_);
    glEnable(GL_BLEND);
    glBlendEquation(GL_MAX);
    hastes_.fill(hasteProgram_, awakeCells_);
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
}

void ContactPass::forgetHaste() const {
    hastes_.bind();
    constexpr GLfloat zero[] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, zero);
}

std::vector<double> ContactPass::haste() const {
    std::vector<double> haste(world_.bodies().size(), 1);
    const auto kept = hastes_.read(0, {0, world_.cellCount()});
    for (int cell = 0; cell < world_.cellCount(); ++cell) {
        double& body = haste[world_.bodyOf(cell)];
        body = std::max(body, hasteOf(std::llround(kept[cell].x)));
    }
    return haste;
}

void raiseHaste(std::vector<double>& haste, const std::vector<double>& by) {
    haste.resize(std::max(haste.size(), by.size()), 1);
    for (std::size_t i = 0; i < by.size(); ++i) haste[i] = std::max(haste[i], by[i]);
}

double hasteOf(std::int64_t quarterOctaves) {
    return std::exp2(0.25 * static_cast<double>(quarterOctaves));
}

}  // namespace sunder::gpu
