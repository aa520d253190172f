// The public interface in a host's own GL context: sunder/gl.hpp.
#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <regex>
#include <sstream>
#include <utility>

#include "catch.hpp"
#include "gl/program.hpp"
#include "gpu/library_host.hpp"
#include "sunder/world_impl.hpp"
#include "surface/display_mesh.hpp"

using namespace sunder;
using namespace library_host;

namespace {

core::Vec3 vec(const float* v) {
    return {v[0], v[1], v[2]};
}

}  // namespace

TEST_CASE("library: a world on a host's GPU has the bits of the program's, for every solver") {
    Host host;
    gl::Device device(host.options());
    REQUIRE(device.ok());
    CHECK(device.renderer() == host.context->info().renderer);
    for (const std::string_view solver : {"gather", "scatter", "cpu", "reference"}) {
        INFO(solver);
        World world = made(wallAndBall(), {.device = &device, .solver = solver});
        CHECK(world.solver() == solver);
        World again = made(wallAndBall(), {.device = &device, .solver = solver});
        for (int i = 0; i < 3; ++i) REQUIRE(world.step(kFrame));
        REQUIRE(again.step(3 * kFrame));
        CHECK(*world.brokenBonds() > 0);
        CHECK(*world.stateHash() == *again.stateHash());
    }
    CHECK(device.memory() == 0);  // all of it has gone with the worlds
}

TEST_CASE("library: a surface is where the mesh that is seen is") {
    Host host;
    gl::Device device(host.options());
    World world = made(wallAndBall(), {.device = &device});
    gl::Surface surface(device, world);
    REQUIRE(surface.ok());
    for (int i = 0; i < 4; ++i) REQUIRE(world.step(kFrame));
    REQUIRE(world.brokenBonds());
    REQUIRE(surface.update());

    const core::World& inside = world.impl().world();
    const surface::DisplayMesh mesh(inside);
    std::unique_ptr<sim::Backend::Stay> stay = world.impl().enter();
    const core::State state = world.impl().simulation->state();
    stay.reset();
    const std::vector<gl::Vertex> vertices = verticesOf(surface);
    REQUIRE(vertices.size() == mesh.vertices().size());
    int hidden = 0, bared = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const surface::DisplayVertex& vertex = mesh.vertices()[i];
        const core::Vec3 normal = vec(vertices[i].normal), tangent = vec(vertices[i].tangent);
        CHECK(normal.norm() == Approx(1).margin(1e-5));
        CHECK(tangent.norm() == Approx(1).margin(1e-5));
        CHECK(normal.dot(tangent) == Approx(0).margin(1e-5));
        CHECK(std::abs(vertices[i].tangent[3]) == 1);
        if (surface::displayHidden(state, vertex)) {
            ++hidden;
            continue;
        }
        bared += (vertex.code & SUNDER_DISPLAY_FACE_INNER) != 0;
        const core::Vec3 place = surface::displayedPosition(inside, state, vertex);
        // Single precision of places up to 2 m.
        CHECK((vec(vertices[i].position) - place).norm() < 2e-6);
    }
    CHECK(hidden > 100);
    CHECK(bared > 10);
}

TEST_CASE("library: a host's own vertex shader moves vertices as update() does, in every solver") {
    Host host;
    gl::Device device(host.options());
    for (const std::string solver : {"gather", "scatter", "auto", "cpu"}) {
        INFO(solver);
        World world = made(wallAndBall(), {.device = &device, .solver = solver});
        gl::Surface surface(device, world);
        std::string text;
        host.unnoticed("shader", [&] { text = *surface.vertexShader(); });
        for (int i = 0; i < 4; ++i) REQUIRE(world.step(kFrame));
        REQUIRE(*world.brokenBonds() > 0);
        REQUIRE(surface.update());
        const std::vector<gl::Vertex> expected = verticesOf(surface);
        const auto rest = contentOf<gl::RestVertex>(surface.restBuffer());
        REQUIRE(rest.size() == expected.size());

        const gl::Program program(
            {.vertex = "host.vert",
             .feedback = {"position", "normal", "tangent", "place", "texCoord", "ofCell", "inside"},
             .source = [&](std::string_view) {
                 return text + R"(
out vec3 position, normal, place;
out vec4 tangent;
out vec2 texCoord;
flat out ivec2 ofCell;
flat out int inside;
void main() {
    SunderVertex vertex = sunderVertex();
    position = vertex.position;
    normal = vertex.normal;
    tangent = vertex.tangent;
    place = vertex.place;
    texCoord = vertex.texCoord;
    ofCell = ivec2(vertex.body, vertex.cell);
    inside = vertex.inside ? 1 : 0;
})";
             }});
        struct Captured {
            gl::Vertex vertex;
            float place[3], texCoord[2];
            std::int32_t body, cell, inside;
        };
        std::vector<Captured> captured(expected.size());
        const gl::Buffer buffer(captured.size() * sizeof captured[0], nullptr, GL_STREAM_READ,
                                "captured");
        std::array<gl::VertexTexture, 5> textures{};
        host.unnoticed("textures", [&] { textures = *surface.vertexTextures(); });
        program.use();
        for (int unit = 0; unit < 5; ++unit) {
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            glBindTexture(GL_TEXTURE_BUFFER, textures[static_cast<std::size_t>(unit)].texture);
            const GLint sampler = program.uniform(textures[static_cast<std::size_t>(unit)].sampler);
            REQUIRE(sampler >= 0);
            glUniform1i(sampler, unit);
        }
        // Nothing is drawn, but without a screen a draw needs a framebuffer.
        const gl::Texture colour = gl::makeTexture2D(1, 1, GL_RGBA8, "nothing");
        const gl::Framebuffer framebuffer = gl::makeFramebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour.id(), 0);
        glBindVertexArray(surface.sourceArray());
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer.id());
        glEnable(GL_RASTERIZER_DISCARD);
        glBeginTransformFeedback(GL_POINTS);
        glDrawArrays(GL_POINTS, 0, surface.vertices());
        glEndTransformFeedback();
        glDisable(GL_RASTERIZER_DISCARD);
        glUseProgram(0);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        CHECK(host.context->takeErrors() == std::vector<std::string>{});
        captured = contentOf<Captured>(buffer.id());

        int shown = 0;
        for (std::size_t i = 0; i < captured.size(); ++i) {
            const Captured& vertex = captured[i];
            // A compiler may round otherwise where the same text is a function: places up to 2 m.
            for (int axis = 0; axis < 3; ++axis) {
                CHECK(std::abs(vertex.vertex.position[axis] - expected[i].position[axis]) < 1e-6);
                CHECK(std::abs(vertex.vertex.normal[axis] - expected[i].normal[axis]) < 1e-4);
                CHECK(std::abs(vertex.vertex.tangent[axis] - expected[i].tangent[axis]) < 1e-4);
            }
            CHECK(vertex.vertex.tangent[3] == expected[i].tangent[3]);
            CHECK((vertex.body == rest[i].body && vertex.cell == rest[i].cell &&
                   vertex.inside == rest[i].inside));
            const core::Vec3 place = vec(vertex.place);
            if (place.isZero()) continue;
            ++shown;
            CHECK((place - vec(rest[i].place)).norm() < 1e-6);
            for (int axis = 0; axis < 2; ++axis)
                CHECK(std::abs(vertex.texCoord[axis] - rest[i].texCoord[axis]) < 1e-6);
        }
        CHECK(shown > 100);
    }
}

TEST_CASE("library: the text for a host's vertex shader takes no name that may be the host's") {
    Host host;
    gl::Device device(host.options());
    World world = made(wallAndBall(), {.device = &device, .settle = false});
    gl::Surface surface(device, world);
    const std::string text = *surface.vertexShader();
    // What is declared begins a line: a macro, a structure, a variable or a function.
    const std::regex declared(
        R"(^(?:#define|struct|(?:(?:layout\(.*\)|in|out|flat|uniform|const|sunder_PASSED|sunder_PASSED_FLAT) +)*[A-Za-z_]\w*) +([A-Za-z_]\w*))");
    std::istringstream lines(text);
    int names = 0;
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (line.empty() || line[0] == '}' || !std::regex_search(line, match, declared)) continue;
        const std::string name = match[1];
        if (name.starts_with("gl_")) continue;
        INFO(line);
        CHECK((name.starts_with("sunder") || name.starts_with("Sunder") ||
               name.starts_with("SUNDER_")));
        ++names;
    }
    CHECK(names > 50);
    CHECK(text.find("#version") == std::string::npos);
    CHECK(text.find("#include") == std::string::npos);
}

TEST_CASE("library: a surface's ranges are all of it, by material, with normals outwards") {
    Host host;
    gl::Device device(host.options());
    World world = made(wallAndBall(), {.device = &device, .settle = false});
    gl::Surface surface(device, world);
    REQUIRE(surface.update());
    const std::vector<gl::Vertex> vertices = verticesOf(surface);
    const auto rest = contentOf<gl::RestVertex>(surface.restBuffer());
    REQUIRE(rest.size() == vertices.size());
    const auto indices = contentOf<std::uint32_t>(surface.indexBuffer());

    std::size_t next = 0;
    int outside = 0;
    bool transparent = false;
    for (const gl::Range& range : surface.ranges()) {
        CHECK(reinterpret_cast<std::size_t>(range.offset) == next * sizeof(std::uint32_t));
        CHECK(range.transparent == (range.material == 1));
        CHECK(transparent <= range.transparent);
        transparent = range.transparent;
        for (int i = 0; i < range.count; i += 3, next += 3) {
            const std::uint32_t* const corner = &indices[next];
            CHECK(rest[corner[0]].material == range.material);
            CHECK(rest[corner[0]].inside == (range.inside ? 1 : 0));
            if (range.inside) continue;
            // A wall at rest: triangles face the way their normals do, which textures agree with.
            const core::Vec3 a = vec(vertices[corner[0]].position),
                             b = vec(vertices[corner[1]].position),
                             c = vec(vertices[corner[2]].position);
            const core::Vec3 normal = vec(vertices[corner[0]].normal);
            CHECK((b - a).cross(c - a).normalized().dot(normal) == Approx(1).margin(1e-4));
            const double du = rest[corner[1]].texCoord[0] - rest[corner[0]].texCoord[0];
            CHECK((b - a).dot(vec(vertices[corner[0]].tangent)) == Approx(du).margin(1e-5));
            ++outside;
        }
    }
    CHECK(next == indices.size());
    CHECK(outside > 100);
}

TEST_CASE("library: no state of a host's changes a surface, nor is it changed") {
    Host host;
    gl::Device device(host.options());
    World world = made(wallAndBall(), {.device = &device});
    for (int i = 0; i < 4; ++i) REQUIRE(world.step(kFrame));
    std::vector<gl::Vertex> expected;
    {
        gl::Surface surface(device, world);
        REQUIRE(surface.update());
        expected = verticesOf(surface);
    }
    const Result<std::vector<std::byte>> saved = world.saveState();
    REQUIRE(saved);
    std::optional<gl::Surface> surface;
    host.unnoticed("made", [&] { surface.emplace(device, world); });
    for (const HostileHost::Setting& setting : host.hostile.settings()) {
        INFO(setting.name);
        REQUIRE(world.restoreState(*saved));  // where it is, so that all is deformed anew
        setting.set(host.hostile);
        host.unnoticed("update", [&] { CHECK(surface->update()); });
        CHECK(surface->changed().size() == 2);
        host.hostile.reset();
        CHECK(same(verticesOf(*surface), expected));
    }
    host.hostile.setAll();
    host.unnoticed("step", [&] { CHECK(world.step(kFrame)); });
    host.unnoticed("update", [&] { CHECK(surface->update()); });
    host.unnoticed("ray", [&] { CHECK(world.castRay({0, 0.3, 2}, {0, 0, -1})); });
    host.unnoticed("push", [&] { CHECK(world.push({.at = {0, 0.3, 0}, .velocity = {0, 0, 1}})); });
    host.unnoticed("saved", [&] { CHECK(world.stateHash()); });
    host.unnoticed("gone", [&] { surface.reset(); });
    host.hostile.reset();
}

TEST_CASE("library: a body that is removed has no visible triangle, and stands again when added") {
    Host host;
    gl::Device device(host.options());
    for (const std::string_view solver : {"gather", "scatter", "auto", "cpu"}) {
        INFO(solver);
        WorldDesc desc = wallAndBall();
        desc.bodies[1].present = false;
        World world = made(desc, {.device = &device, .solver = solver});
        gl::Surface surface(device, world);
        const surface::DisplayMesh mesh(world.impl().world());
        std::vector<gl::Vertex> vertices;
        const auto update = [&] {
            host.unnoticed("update", [&] { REQUIRE(surface.update()); });
            vertices = verticesOf(surface);
            REQUIRE(vertices.size() == mesh.vertices().size());
        };
        /// Triangles of a body's cells whose corners are not all in one place.
        const auto visible = [&](int body) {
            int count = 0;
            for (std::size_t i = 0; i < mesh.indices().size(); i += 3) {
                const std::uint32_t a = mesh.indices()[i], b = mesh.indices()[i + 1],
                                    c = mesh.indices()[i + 2];
                if (world.impl().world().bodyOf(static_cast<int>(mesh.vertices()[a].cell)) != body)
                    continue;
                count += vec(vertices[a].position) != vec(vertices[b].position) ||
                         vec(vertices[a].position) != vec(vertices[c].position);
            }
            return count;
        };
        const auto met = [&](double x) {
            const auto hit = world.castRay({x, 0.1, 5}, {0, 0, -1});
            return hit ? hit->body : -1;
        };
        update();
        const int whole = visible(0);
        CHECK(whole > 100);
        CHECK(visible(1) == 0);
        CHECK(met(1.2) == -1);
        for (int i = 0; i < 4; ++i) REQUIRE(world.step(kFrame));
        CHECK(*world.brokenBonds() > 0);
        host.unnoticed("add", [&] { REQUIRE(world.addBody(1)); });
        host.unnoticed("remove", [&] { REQUIRE(world.removeBody(0)); });
        for (int i = 0; i < 3; ++i) {  // whatever half of a ping-pong is drawn
            update();
            CHECK(visible(0) == 0);
            CHECK(visible(1) > 20);
            CHECK(met(0) == -1);
            CHECK(met(1.2) == 1);
            CHECK(*world.brokenBonds() == 0);
            REQUIRE(world.step(0.003));
        }
        REQUIRE(world.removeObject(0));
        REQUIRE(world.addBody(0));
        REQUIRE(world.step(kFrame));
        update();
        CHECK(visible(0) == whole);
        CHECK(met(0) == 0);
        CHECK(world.pieces()->size() == 2);
    }
}

TEST_CASE("library: a world on the GPU goes back to where it was saved") {
    Host host;
    gl::Device device(host.options());
    for (const std::string_view solver : {"gather", "scatter"}) {
        INFO(solver);
        World world = made(wallAndBall(), {.device = &device, .solver = solver});
        REQUIRE(world.step(2 * kFrame));
        const Result<std::vector<std::byte>> saved = world.saveState();
        REQUIRE(saved);
        REQUIRE(world.step(3 * kFrame));
        const std::uint64_t later = *world.stateHash();
        REQUIRE(world.restoreState(*saved));
        REQUIRE(world.step(3 * kFrame));
        CHECK(*world.stateHash() == later);
        World other = made(wallAndBall(), {.device = &device, .solver = "cpu"});
        CHECK_THAT(other.restoreState(*saved).error().message,
                   Catch::Contains(std::string(solver)));
    }
}

TEST_CASE("library: pushes, throws and surfaces read nothing back") {
    Host host;
    gl::Device device(host.options());
    for (const std::string_view solver : {"gather", "scatter"}) {
        INFO(solver);
        World quiet = made(wallAndBall(), {.device = &device, .solver = solver, .incidents = 0});
        World pushed = made(wallAndBall(), {.device = &device, .solver = solver, .incidents = 0});
        gl::Surface surface(device, pushed);
        ReadCounter counter(device.impl().driver->functions());
        // Without incidents, there are looks for sleepers and contacts left out alone: answers that
        // came two looks ago, of which there is one a sixtieth of a second or so.
        std::vector<int> reads, readsOfPushed;
        for (int frame = 0; frame < 8; ++frame) {
            const Push blast{.at = {0, 0.3, 0}, .radius = 0.2, .outward = 0.1, .falloff = true};
            REQUIRE(quiet.push(blast));  // which keeps it awake
            REQUIRE(quiet.throwObject({.object = 0, .from = {0, 0.5, 2}}));
            REQUIRE(quiet.step(kFrame));
            reads.push_back(ReadCounter::take());
            for (int i = 0; i < 100; ++i) REQUIRE(pushed.push(blast));
            REQUIRE(pushed.throwObject({.object = 0, .from = {0, 0.5, 2}}));
            REQUIRE(pushed.step(kFrame));
            REQUIRE(surface.update());
            readsOfPushed.push_back(ReadCounter::take());
        }
        for (std::size_t frame = 0; frame < reads.size(); ++frame) {
            INFO("frame " << frame);
            CHECK(readsOfPushed[frame] <= reads[frame]);
        }
        CHECK(pushed.stateHash());
        CHECK(ReadCounter::take() > 0);  // it does count
        CHECK(*pushed.stateHash() != *quiet.stateHash());
    }
}

TEST_CASE("library: a world on the CPU has a surface, too") {
    Host host;
    gl::Device device(host.options());
    World onCpu = made(wallAndBall(), {});
    World onGpu = made(wallAndBall(), {.device = &device, .solver = "cpu"});
    gl::Surface a(device, onCpu), b(device, onGpu);
    REQUIRE(a.ok());
    for (int i = 0; i < 3; ++i) {
        REQUIRE(onCpu.step(kFrame));
        REQUIRE(onGpu.step(kFrame));
    }
    REQUIRE(a.update());
    REQUIRE(b.update());
    CHECK(same(verticesOf(a), verticesOf(b)));
}

TEST_CASE("library: a device without functions, without a context, or of one that is gone") {
    gl::Device none({});
    CHECK_FALSE(none.ok());
    CHECK(none.error().code == Error::Code::Input);
    CHECK(World::create(wallAndBall(), {.device = &none}).error().message == none.error().message);
    gl::Device empty({.getProcAddress = [](const char*) { return static_cast<void*>(nullptr); }});
    CHECK_FALSE(empty.ok());
    CHECK(empty.error().code == Error::Code::Device);

    auto host = std::make_unique<Host>();
    gl::Device device(host->options());
    World world = made(wallAndBall(), {.device = &device});
    gl::Surface surface(device, world);
    gl::Surface never(none, world);
    CHECK_FALSE(never.ok());
    CHECK_FALSE(never.update());
    CHECK(never.vertexArray() == 0);
    host.reset();
    device.contextGone();
    const Result<void> stepped = world.step(kFrame);
    REQUIRE_FALSE(stepped);
    CHECK(stepped.error().code == Error::Code::Device);
    CHECK_FALSE(surface.update());
    CHECK_FALSE(world.castRay({0, 0.3, 2}, {0, 0, -1}).has_value());
    CHECK_FALSE(world.pieces());
}

TEST_CASE("library: a host that is in the midst of something is told so, and can go on") {
    Host host;
    gl::Device device(host.options());
    World world = made(wallAndBall(), {.device = &device});
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    const Result<void> refused = world.step(kFrame);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == Error::Code::Input);
    glEndQuery(GL_SAMPLES_PASSED);
    glDeleteQueries(1, &query);
    CHECK(world.time() == 0);
    CHECK(world.step(kFrame));
    CHECK(world.substeps() == 50);
}
