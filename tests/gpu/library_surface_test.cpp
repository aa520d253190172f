// What a Surface updates, and pieces on it: sunder/gl.hpp.
#include <algorithm>
#include <set>

#include "core/pieces.hpp"
#include "gpu/library_host.hpp"
#include "sunder/sunder.h"
#include "sunder/world_impl.hpp"

using namespace sunder;
using namespace library_host;

namespace {

/// Three walls far from each other and a ball that stands still: what is hit moves, all else
/// sleeps.
WorldDesc threeWalls() {
    WorldDesc desc;
    const int brick = desc.addMaterial(Material::preset("brick"));
    for (int i = 0; i < 3; ++i)
        desc.addBody({.material = brick,
                      .size = {0.9, 0.6, 0.2},
                      .cells = {6, 4, 2},
                      .position = {3. * i, 0, 0},
                      .anchors = Side::Bottom});
    return desc;
}

std::set<int> changedBodies(const gl::Surface& surface) {
    std::set<int> bodies;
    for (const gl::VertexRange& range : surface.changed()) {
        CHECK(range.count > 0);
        bodies.insert(range.body);
    }
    return bodies;
}

}  // namespace

TEST_CASE("library: a surface updates what has changed, and is as if it had updated everything") {
    Host host;
    gl::Device device(host.options());
    for (const std::string_view solver : {"gather", "scatter", "cpu"}) {
        INFO(solver);
        const bool sleeps = solver != "scatter";
        WorldDesc desc = threeWalls();
        World world = made(desc, {.device = &device, .solver = solver});
        gl::Surface surface(device, world);
        std::vector<gl::Vertex> last;
        /// Which bodies were written. All vertices are those of a surface that is made anew, and
        /// where nothing was written they are those of before.
        const auto updated = [&] {
            REQUIRE(surface.update());
            const std::vector<gl::Vertex> now = verticesOf(surface);
            gl::Surface anew(device, world);
            REQUIRE(anew.update());
            CHECK(same(now, verticesOf(anew)));
            CHECK(changedBodies(anew).size() == desc.bodies.size());
            const std::set<int> bodies = changedBodies(surface);
            if (bodies.empty()) CHECK(same(now, last));
            last = now;
            return bodies;
        };
        const auto rest = [&] {
            for (int i = 0; i < 300; ++i) REQUIRE(world.step(kFrame));
            REQUIRE(world.finish());
        };
        rest();
        CHECK(updated() == std::set{0, 1, 2});
        if (sleeps) CHECK(updated().empty());
        REQUIRE(world.step(kFrame));
        CHECK(updated() == (sleeps ? std::set<int>{} : std::set{0, 1, 2}));

        // One is hit, and comes to rest.
        REQUIRE(world.push({.body = 1, .at = {3, 0.4, 0}, .radius = 0.25, .velocity = {0, 0, 40}}));
        for (int i = 0; i < 6; ++i) {
            REQUIRE(world.step(kFrame));
            CHECK(updated() == (sleeps ? std::set{1} : std::set{0, 1, 2}));
        }
        REQUIRE(world.finish());
        CHECK(*world.brokenBonds() > 0);
        const std::vector<std::byte> saved = *world.saveState();
        if (sleeps) {
            rest();
            rest();
            updated();
            CHECK(updated().empty());
            // It wakes and sleeps again between two updates.
            REQUIRE(world.push({.body = 0, .at = {0, 0.5, 0}, .velocity = {0, 0, 0.1}}));
            REQUIRE(world.step(20));
            CHECK(updated().count(0) == 1);
        }
        REQUIRE(world.restoreState(saved));
        CHECK(updated() == std::set{0, 1, 2});

        REQUIRE(world.removeBody(2));
        REQUIRE(world.step(kFrame));
        CHECK(updated().count(2) == 1);
        REQUIRE(world.addBody(2));
        REQUIRE(world.step(kFrame));
        CHECK(updated().count(2) == 1);

        // A larger world is a surface of its own.
        const unsigned before = surface.vertexArray();
        const int vertices = surface.vertices();
        desc.addBody(desc.bodies[0]);
        desc.bodies.back().position = {0, 0, 5};
        host.unnoticed("extend", [&] { REQUIRE(world.extend(desc)); });
        CHECK(surface.vertexArray() == before);
        CHECK(updated() == std::set{0, 1, 2, 3});
        CHECK(surface.vertices() > vertices);
        CHECK(surface.vertexTextures());
    }
    CHECK(device.memory() == 0);
}

TEST_CASE("library: a surface's vertices know their pieces") {
    Host host;
    gl::Device device(host.options());
    for (const std::string_view solver : {"gather", "cpu"}) {
        INFO(solver);
        WorldDesc desc = threeWalls();
        World world = made(desc, {.device = &device, .solver = solver});
        gl::Surface without(device, world);
        CHECK(without.pieceBuffer() == 0);
        gl::Surface surface(device, world, {.pieces = true});
        const auto rest = contentOf<gl::RestVertex>(surface.restBuffer());
        /// Every vertex has the number of its cell's piece, of the state that is looked at.
        const auto right = [&] {
            host.unnoticed("update", [&] { REQUIRE(surface.update()); });
            const auto pieces = contentOf<std::int32_t>(surface.pieceBuffer());
            REQUIRE(pieces.size() == rest.size());
            sim::Simulation& inside = *world.impl().simulation;
            const core::Pieces expected = core::findPieces(inside.world(), inside.lateState());
            CHECK(world.pieces()->size() == static_cast<std::size_t>(expected.count));
            std::set<std::int32_t> seen;
            bool same = true;
            for (std::size_t i = 0; i < rest.size(); ++i) {
                same = same && pieces[i] == expected.ofCell[rest[i].cell];
                seen.insert(pieces[i]);
            }
            CHECK(same);
            return seen;
        };
        CHECK(right() == std::set<std::int32_t>{0, 1, 2});
        REQUIRE(world.push({.body = 1, .at = {3, 0.4, 0}, .radius = 0.25, .velocity = {0, 0, 40}}));
        std::size_t most = 0;
        for (int i = 0; i < 12; ++i) {
            REQUIRE(world.step(kFrame));
            most = std::max(most, right().size());
        }
        CHECK(most > 3);
        REQUIRE(world.removeBody(0));
        REQUIRE(world.step(kFrame));
        CHECK(right().count(-1) == 1);
        // A mesh that is made anew while nothing breaks.
        desc.addObject(Object::sphere(0.1).at({0, 0.1, 5}));
        REQUIRE(world.finish());
        REQUIRE(surface.update());
        REQUIRE(world.extend(desc));
        CHECK(right().size() > 3);
        // The attribute that hosts read it by.
        glBindVertexArray(surface.vertexArray());
        GLint buffer = 0, integer = 0;
        glGetVertexAttribiv(9, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &buffer);
        glGetVertexAttribiv(9, GL_VERTEX_ATTRIB_ARRAY_INTEGER, &integer);
        glBindVertexArray(0);
        CHECK(buffer == static_cast<GLint>(surface.pieceBuffer()));
        CHECK(integer == 1);
    }
}

TEST_CASE("library: C has the surface that C++ has") {
    Host host;
    static const Host* current = nullptr;
    current = &host;
    sunder_device* const device = sunder_device_create(
        [](const char* name) {
            return reinterpret_cast<sunder_gl_function>(current->context->loadFunction()(name));
        },
        0);
    REQUIRE(device);
    CHECK(sunder_device_create(nullptr, 0) == nullptr);
    CHECK(std::string(sunder_message()) != "");
    sunder_desc* const desc = sunder_desc_preset("brick");
    REQUIRE(desc);
    sunder_world* const world = sunder_world_create(desc, device, nullptr);
    REQUIRE(world);
    CHECK(sunder_surface_create(nullptr, world, 0) == nullptr);
    sunder_surface* const surface = sunder_surface_create(device, world, 1);
    REQUIRE(surface);
    for (int i = 0; i < 4; ++i) REQUIRE(sunder_world_step(world, kFrame) == SUNDER_OK);
    CHECK(sunder_surface_update(nullptr) == SUNDER_INPUT);
    host.unnoticed("update", [&] { REQUIRE(sunder_surface_update(surface) == SUNDER_OK); });
    CHECK(sunder_world_look_time(world) > 0);

    // The same in C++.
    gl::Device own(host.options());
    World same = made(*WorldDesc::preset("brick"), {.device = &own});
    gl::Surface expected(own, same, {.pieces = true});
    for (int i = 0; i < 4; ++i) REQUIRE(same.step(kFrame));
    REQUIRE(expected.update());
    CHECK(sunder_surface_vertices(surface) == expected.vertices());
    const auto equal = [](const auto& a, const auto& b) {
        return a.size() == b.size() && !a.empty() &&
               std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
    };
    CHECK(equal(contentOf<gl::Vertex>(sunder_surface_vertex_buffer(surface)),
                contentOf<gl::Vertex>(expected.vertexBuffer())));
    CHECK(equal(contentOf<gl::RestVertex>(sunder_surface_rest_buffer(surface)),
                contentOf<gl::RestVertex>(expected.restBuffer())));
    CHECK(equal(contentOf<std::uint32_t>(sunder_surface_index_buffer(surface)),
                contentOf<std::uint32_t>(expected.indexBuffer())));
    CHECK(contentOf<std::int32_t>(sunder_surface_piece_buffer(surface)).size() ==
          static_cast<std::size_t>(expected.vertices()));
    CHECK(sunder_surface_vertex_array(surface) != sunder_surface_source_array(surface));
    const sunder_vertex_range* changed = nullptr;
    REQUIRE(sunder_surface_changed(surface, &changed) == expected.changed().size());
    CHECK(changed[0].count == expected.changed()[0].count);
    const sunder_range* ranges = nullptr;
    REQUIRE(sunder_surface_ranges(surface, &ranges) == expected.ranges().size());
    for (const gl::Range& range : expected.ranges()) {
        CHECK(ranges->material == range.material);
        CHECK(ranges->count == range.count);
        CHECK(ranges->offset == reinterpret_cast<std::size_t>(range.offset));
        ++ranges;
    }
    const char* text = nullptr;
    REQUIRE(sunder_surface_vertex_shader(surface, &text) == SUNDER_OK);
    CHECK(text == *expected.vertexShader());
    sunder_vertex_texture textures[5];
    REQUIRE(sunder_surface_vertex_textures(surface, textures) == SUNDER_OK);
    const auto inCpp = *expected.vertexTextures();
    for (std::size_t i = 0; i < inCpp.size(); ++i) {
        CHECK(std::string(textures[i].sampler) == inCpp[i].sampler);
        CHECK(textures[i].texture != 0);
    }
    CHECK(sunder_surface_vertex_shader(surface, nullptr) == SUNDER_INPUT);
    CHECK(sunder_surface_vertex_textures(nullptr, textures) == SUNDER_INPUT);
    sunder_surface_destroy(surface);
    sunder_world_destroy(world);
    sunder_desc_destroy(desc);
    sunder_device_destroy(device);
    sunder_device_destroy(nullptr);
    sunder_surface_destroy(nullptr);
}
