// The mesh that is seen, as the GPU moves and draws it.
#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <set>

#include "catch.hpp"
#include "cpu/cpu_solver.hpp"
#include "gl/program.hpp"
#include "gpu/pictures.hpp"
#include "gpu/test_context.hpp"
#include "render/display_pass.hpp"
#include "render/picture_target.hpp"
#include "scene/scene.hpp"
#include "support/turned_worlds.hpp"
#include "support/worlds.hpp"
#include "surface/display_mesh.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// A wall of a preset's material, hit in the middle.
WorldDescription presetWall(const std::string& material, double speed) {
    WorldDescription description;
    description.materials = {scene::loadMaterial(material)};
    BodyDescription wall;
    wall.name = "wall";
    wall.size = {1.6, 1.2, 0.1};
    wall.cells = {16, 12, 1};
    wall.anchors = {Side::Bottom, Side::Left};
    description.bodies = {wall};
    EventDescription event = hit(0, {0.1, 0.6, 0.05}, {0, 0, -speed});
    description.events = {event};
    description.contact = true;
    description.ground = false;
    return description;
}

State afterFrames(const World& world, int frames) {
    cpu::CpuSolver solver(world, 2);
    solver.advance(50 * frames);
    return solver.state();
}

/// Bent as a sheet is, by up to `far` m.
State bent(const World& world, double far) {
    State state = world.initialState();
    for (int node = 0; node < world.nodeCount(); ++node) {
        const Vec3 x = world.restPosition(node);
        state.displacement[node] = {0.1 * far * std::sin(4 * x[1]), 0.05 * far * x[0],
                                    far * std::sin(2.5 * x[0]) * std::cos(1.5 * x[1])};
    }
    return state;
}

/// What the shader makes of a vertex; hidden ones are at (0, 0, 0).
struct Moved {
    glm::vec3 position, normal, place;
};

std::vector<Moved> movedVertices(const World& world, const State& state,
                                 const surface::DisplayMesh& mesh) {
    testContext();
    const gpu::WorldBuffers buffers(world);
    gpu::StateUpload upload(world);
    const gpu::StateView view = upload.upload(state);
    const render::DisplayBuffers meshBuffers(mesh);
    const gl::Buffer captured(sizeof(Moved) * mesh.vertices().size(), nullptr, GL_STATIC_READ,
                              "positions");
    const render::DisplayPass pass(render::DisplayPass::Output::Captured, buffers, meshBuffers);
    const render::PictureTarget target(16, 16, 1);  // drawing wants one bound, even to discard
    target.begin(glm::vec3(0));
    pass.begin();
    glEnable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, captured.id());
    glBeginTransformFeedback(GL_POINTS);
    pass.drawVertices(view);
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    std::vector<Moved> result(mesh.vertices().size());
    captured.read(0, captured.size(), result.data());
    CHECK_THAT(testContext().takeErrors(), Catch::Matchers::Equals(std::vector<std::string>{}));
    return result;
}

image::Image cutOut(Painter& painter, const State& state, const scene::CameraDescription& camera,
                    const glm::vec3& background, render::DrawnMesh mesh) {
    render::RenderSettings settings;
    settings.mesh = mesh;
    settings.background = background;
    return painter.picture(state, camera, settings);
}

/// Per pixel: whether anything of the background shows in any sample. Two backgrounds tell, however
/// the wall is coloured.
std::vector<bool> backgroundShows(Painter& painter, const State& state,
                                  const scene::CameraDescription& camera, render::DrawnMesh mesh) {
    const image::Image a = cutOut(painter, state, camera, {1, 0, 1}, mesh);
    const image::Image b = cutOut(painter, state, camera, {0, 1, 0}, mesh);
    std::vector<bool> shows;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) shows.push_back(difference(a, b, x, y) > 0);
    return shows;
}

/// Pixels through which the display mesh shows the background well inside of the simulation mesh's
/// outline: none of the pixels around them shows it there.
int holes(Painter& painter, const State& state, const scene::CameraDescription& camera,
          int& inside) {
    const std::vector<bool> simulation =
        backgroundShows(painter, state, camera, render::DrawnMesh::Simulation);
    const std::vector<bool> display =
        backgroundShows(painter, state, camera, render::DrawnMesh::Display);
    int count = 0;
    inside = 0;
    for (int y = 2; y < kHeight - 2; ++y)
        for (int x = 2; x < kWidth - 2; ++x) {
            bool covered = true;
            for (int dy = -2; dy <= 2; ++dy)
                for (int dx = -2; dx <= 2; ++dx)
                    covered = covered && !simulation[(y + dy) * kWidth + x + dx];
            inside += covered;
            count += covered && display[y * kWidth + x];
        }
    return count;
}

const char* const kMaterials[] = {"wood",   "planks",      "concrete",     "brick",
                                  "rubber", "wood-thesis", "rubber-thesis"};

}  // namespace

TEST_CASE("displayed positions are those of the barycentric coordinates, on a bent and broken wall",
          "[display]") {
    for (const char* material : {"wood", "concrete", "brick"}) {
        CAPTURE(material);
        const World world(presetWall(material, 40));
        const surface::DisplayMesh mesh(world);
        State state = afterFrames(world, 12);
        const State bend = bent(world, 0.2);
        for (int node = 0; node < world.nodeCount(); ++node)
            state.displacement[node] += bend.displacement[node];
        state = roundedToSingle(state);
        REQUIRE(std::count_if(state.damage.begin(), state.damage.end(),
                              [](double d) { return d >= 1 && d < kNoBond; }) > 50);

        const std::vector<Moved> moved = movedVertices(world, state, mesh);
        double most = 0;
        int seen = 0;
        for (std::size_t i = 0; i < moved.size(); ++i) {
            const surface::DisplayVertex& vertex = mesh.vertices()[i];
            const glm::vec3& p = moved[i].position;
            const Vec3 onGpu(p.x, p.y, p.z);
            if (surface::displayHidden(state, vertex)) {
                REQUIRE(onGpu == Vec3(0, 0, 0));
                continue;
            }
            ++seen;
            most =
                std::max(most, (onGpu - surface::displayedPosition(world, state, vertex)).norm());
        }
        CHECK(seen > static_cast<int>(moved.size()) / 4);
        CHECK(most < 1e-5);
    }
}

TEST_CASE("a turned wall is seen as its twin is, turned", "[display]") {
    const Mat3 turn = Eigen::AngleAxisd(2.1, Vec3(1, -2, 0.7).normalized()).toRotationMatrix();
    for (const char* material : {"wood", "brick"}) {
        CAPTURE(material);
        const WorldDescription d = presetWall(material, 40);
        const World twin(d), world(turnedWorld(d, turn));
        State expected = afterFrames(twin, 12);
        const State bend = bent(twin, 0.2);
        for (int node = 0; node < twin.nodeCount(); ++node)
            expected.displacement[node] += bend.displacement[node];
        expected = roundedToSingle(expected);
        const State state = roundedToSingle(turnedState(expected, turn));
        const surface::DisplayMesh mesh(world), other(twin);
        REQUIRE(mesh.vertices().size() == other.vertices().size());
        REQUIRE(mesh.indices() == other.indices());
        const std::vector<Moved> moved = movedVertices(world, state, mesh);
        const std::vector<Moved> twins = movedVertices(twin, expected, other);
        const auto vector = [](const glm::vec3& v) { return Vec3(v.x, v.y, v.z); };
        double most = 0, tilt = 0, slipped = 0;
        int seen = 0;
        for (std::size_t i = 0; i < moved.size(); ++i) {
            REQUIRE(mesh.vertices()[i].code == other.vertices()[i].code);
            if (surface::displayHidden(state, mesh.vertices()[i])) continue;
            ++seen;
            const Vec3 place = vector(moved[i].position);
            most = std::max({most, (place - turn * vector(twins[i].position)).norm(),
                             (place - displayedPosition(world, state, mesh.vertices()[i])).norm()});
            slipped = std::max(slipped, (vector(moved[i].place) - vector(twins[i].place)).norm());
            const Vec3 normal = vector(moved[i].normal), twinNormal = vector(twins[i].normal);
            REQUIRE(normal.isZero(0) == twinNormal.isZero(0));
            if (!normal.isZero(0))
                tilt =
                    std::max(tilt, (normal.normalized() - turn * twinNormal.normalized()).norm());
        }
        CHECK(seen > static_cast<int>(moved.size()) / 4);
        // Single precision: of places within 2 m; and of edges of a tenth of that.
        CHECK(most < 1e-5);
        CHECK(tilt < 1e-4);
        CHECK(slipped < 2e-6);  // bricks lie in their rows
    }
}

TEST_CASE("the outside of a bent sheet has the normals of what it is bent to", "[display]") {
    const World world(presetWall("rubber", 0));
    const Body& body = world.bodies()[0];
    const double radius = 1.5;  // m: rolled round a cylinder along y, without stretching the middle
    State state = world.initialState();
    for (int node = 0; node < world.nodeCount(); ++node) {
        const Vec3 x = world.restPosition(node);
        const double angle = x[0] / radius, r = radius + x[2];
        state.displacement[node] =
            Vec3(r * std::sin(angle), x[1], r * std::cos(angle) - radius) - x;
    }
    state = roundedToSingle(state);
    const surface::DisplayMesh mesh(world);
    const std::vector<Moved> moved = movedVertices(world, state, mesh);
    std::map<std::array<float, 3>, glm::vec3> known;  // by rest position
    int front = 0, shared = 0;
    double sum = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const surface::DisplayVertex& v = mesh.vertices()[i];
        if ((v.code >> SUNDER_DISPLAY_FACE_BIT & 7) != 5) continue;
        ++front;
        const glm::vec3 n = glm::normalize(moved[i].normal);
        const double angle = v.rest[0] / radius;
        const glm::vec3 exact(std::sin(angle), 0, std::cos(angle));
        // In cells: one spans 0.067 rad, and a face that is bent in itself would be off by half of
        // that where it ends. At the rim there is no second cell to take the mean with.
        const double off = glm::distance(n, exact) * radius / body.cellSize[0];
        CHECK(off < 0.5);
        sum += off;
        const auto [same, isNew] = known.emplace(std::array{v.rest[0], v.rest[1], v.rest[2]}, n);
        if (isNew) continue;
        ++shared;
        REQUIRE(same->second == n);
    }
    CHECK(front > 192 * 4);
    CHECK(sum / front < 0.2);  // faces by themselves: a third
    CHECK(shared > 192);
}

TEST_CASE("no background shows through an intact wall, straight or bent, from any side",
          "[display][long]") {
    for (const char* material : kMaterials) {
        const World world(presetWall(material, 0));
        Painter painter(world);
        for (const double far : {0.0, 0.3}) {
            const State state = bent(world, far);
            for (const Vec3& eye : {Vec3(0, 0.6, 2.1), Vec3(1.7, 1.5, 1.2), Vec3(-1.2, 0.3, -1.6),
                                    Vec3(0.3, 2.6, 0.9)}) {
                CAPTURE(material, far, eye.transpose());
                scene::CameraDescription camera;
                camera.position = eye;
                camera.target = {0, 0.6, 0};
                int inside = 0;
                CHECK(holes(painter, state, camera, inside) == 0);
                CHECK(inside > kWidth * kHeight / 25);
            }
        }
    }
}

TEST_CASE("no background shows through a turned wall", "[display]") {
    const Mat3 turn = Eigen::AngleAxisd(0.6, Vec3(1, 2, -2) / 3).toRotationMatrix();
    for (const char* material : {"concrete", "brick"}) {
        const WorldDescription d = presetWall(material, 0);
        const World twin(d), world(turnedWorld(d, turn));
        Painter painter(world);
        const State state = turnedState(bent(twin, 0.3), turn);
        for (const Vec3& eye : {Vec3(0, 0.6, 2.1), Vec3(-1.2, 0.3, -1.6)}) {
            CAPTURE(material, eye.transpose());
            scene::CameraDescription camera;
            camera.position = turn * eye;
            camera.target = turn * Vec3(0, 0.6, 0);
            int inside = 0;
            CHECK(holes(painter, state, camera, inside) == 0);
            CHECK(inside > kWidth * kHeight / 25);
        }
    }
}

TEST_CASE("a broken wall of every material covers what it should, in more than one colour",
          "[display]") {
    for (const char* material : kMaterials) {
        CAPTURE(material);
        const bool thesis = std::string(material).ends_with("-thesis");
        const World world(presetWall(material, thesis ? 4 : 40));
        scene::CameraDescription camera;
        camera.position = {0, 0.6, 2.4};
        camera.target = {0, 0.6, 0};
        Painter painter(world);
        const State rest = world.initialState();
        const State broken = afterFrames(world, 15);
        int shown[2], colours[2];
        int i = 0;
        for (const State* state : {&rest, &broken}) {
            const std::vector<bool> shows =
                backgroundShows(painter, *state, camera, render::DrawnMesh::Display);
            const image::Image image =
                cutOut(painter, *state, camera, {1, 0, 1}, render::DrawnMesh::Display);
            std::set<int> seen;
            shown[i] = 0;
            for (int y = 0; y < kHeight; ++y)
                for (int x = 0; x < kWidth; ++x) {
                    if (shows[y * kWidth + x]) continue;
                    ++shown[i];
                    seen.insert(brightness(image, x, y) / 6);
                }
            colours[i] = static_cast<int>(seen.size());
            ++i;
        }
        // The wall's front, by its corners.
        const glm::vec2 low = project(world, camera, {-0.8f, 1.2f, 0.05f});
        const glm::vec2 high = project(world, camera, {0.8f, 0, 0.05f});
        const double front = (high.x - low.x) * (high.y - low.y);
        CHECK(shown[0] == Approx(front).epsilon(0.03));
        CHECK(colours[0] >= 2);
        const bool breaks = std::any_of(broken.damage.begin(), broken.damage.end(),
                                        [](double d) { return d >= 1 && d < kNoBond; });
        CHECK(breaks == (std::string(material) != "rubber-thesis"));
        CHECK(shown[1] > 0.3 * front);
        if (breaks && std::string(material) != "rubber") CHECK(shown[1] < 0.98 * shown[0]);
        CHECK(colours[1] >= 4);
    }
}

TEST_CASE("a pane of glass is seen where it is, and less of it once it is shattered", "[display]") {
    const World world(presetWall("glass", 15));
    Painter painter(world);
    scene::CameraDescription camera;
    camera.position = {0, 0.6, 2.4};
    camera.target = {0, 0.6, 0};
    const glm::vec3 white(1);  // whatever glass does to it makes it darker
    const image::Image empty =
        cutOut(painter, nowhere(world), camera, white, render::DrawnMesh::Display);
    const glm::vec2 low = project(world, camera, {-0.8f, 1.2f, 0.05f});
    const glm::vec2 high = project(world, camera, {0.8f, 0, 0.05f});
    const double front = (high.x - low.x) * (high.y - low.y);
    const auto seen = [&](const State& state) {
        return differing(cutOut(painter, state, camera, white, render::DrawnMesh::Display), empty,
                         2);
    };
    const int whole = seen(world.initialState());
    CHECK(whole == Approx(front).epsilon(0.03));
    const State shattered = afterFrames(world, 30);
    CHECK(seen(shattered) < 0.95 * whole);
    CHECK(seen(shattered) > 0.2 * whole);
}

TEST_CASE("a crack shows before it opens, and only along the broken bonds", "[display]") {
    const World world(presetWall("concrete", 0));
    Painter painter(world);
    const Body& wall = world.bodies()[0];
    State state = world.initialState();
    for (int row = 3; row < 9; ++row) breakBond(state, wall.cellAt({7, row, 0}), 0);
    scene::CameraDescription camera;
    camera.position = {0, 0.6, 1.2};
    camera.target = {0, 0.6, 0};
    const image::Image intact =
        cutOut(painter, world.initialState(), camera, {1, 0, 1}, render::DrawnMesh::Display);
    const image::Image cracked =
        cutOut(painter, state, camera, {1, 0, 1}, render::DrawnMesh::Display);
    const glm::vec2 top = project(world, camera, {0, 0.9f, 0.05f});
    const glm::vec2 bottom = project(world, camera, {0, 0.3f, 0.05f});
    // Edge points and corners lie within half a cell of where the bonds are: 12 pixels.
    const float halfCell = 0.5f * (project(world, camera, {0.1f, 0.6f, 0.05f}).x - top.x);
    const auto near = [&](float x, float y) {
        return std::abs(x - top.x) < halfCell + 2 && y > top.y - halfCell - 2 &&
               y < bottom.y + halfCell + 2;
    };
    const auto far = [&](float x, float y) { return !near(x, y); };
    CHECK(differing(intact, cracked, 6, near) > static_cast<int>(0.5f * (bottom.y - top.y)));
    CHECK(differing(intact, cracked, 6, far) == 0);
}
