// What surfaces look like: colours that can be computed, textures that stay where they belong.
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <optional>

#include "../../glsl/draw/sun.h"
#include "catch.hpp"
#include "core/strength_map.hpp"
#include "gpu/pictures.hpp"
#include "scene/scene.hpp"

using namespace sunder;
using namespace sunder::core;
using glm::vec3;

namespace {

/// A wall of a preset's material like wallDescription()'s, with finer cells.
WorldDescription wallOf(const std::string& material, const Vec3& size = {2, 1, 0.1}) {
    WorldDescription description = wallDescription();
    description.materials = {scene::loadMaterial(material)};
    description.bodies[0].size = size;
    description.bodies[0].cells = {16, 8, 1};
    return description;
}

/// Every bond broken, and cells apart, so that all their faces are seen.
State burst(const World& world) {
    State state = world.initialState();
    std::fill(state.damage.begin(), state.damage.end(), 1.f);
    const Body& body = world.bodies()[0];
    for (int cell = 0; cell < world.cellCount(); ++cell) {
        const Vec3 middle = 0.5 * body.cells.cast<double>();
        const Vec3 way = body.coordinates(cell).cast<double>() - middle;
        for (int corner = 0; corner < kCorners; ++corner)
            state.displacement[kCorners * cell + corner] = 0.03 * way;
    }
    return state;
}

vec3 colourAt(const image::Image& image, int x, int y) {
    const std::uint8_t* p = &image.pixels[3 * (std::size_t{static_cast<unsigned>(y)} * kWidth + x)];
    return {p[0], p[1], p[2]};
}

/// Mean over a rectangle of pixels.
vec3 meanColour(const image::Image& image, const glm::ivec2& low, const glm::ivec2& high) {
    vec3 sum(0);
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x) sum += colourAt(image, x, y);
    return sum / static_cast<float>((high.x - low.x) * (high.y - low.y));
}

// --- The light of glsl/draw, once more and in C++ ---

vec3 skyLight(const vec3& n) {
    const vec3 up(0.361f, 0.469f, 0.649f), sideways(0.216f, 0.271f, 0.354f),
        sunwards(0.023f, 0.017f, 0.010f), ground(0.25f, 0.225f, 0.19f);
    const vec3 sun = SUNDER_SUN_DIRECTION;
    const float towards = glm::dot(glm::vec2(n.x, n.z), glm::normalize(glm::vec2(sun.x, sun.z)));
    return sideways + sunwards * towards + n.y * (0.5f * up + n.y * (0.5f * up - sideways)) +
           ground * (0.5f - 0.5f * n.y);
}

/// Light of a sunlit surface with roughness 0.6 towards the unit vector `view`, without a floor.
vec3 sunlit(const vec3& albedo, const vec3& n, const vec3& view) {
    const vec3 sun = glm::normalize(SUNDER_SUN_DIRECTION), sunLight(1.75f, 1.53f, 1.22f);
    const float roughness = 0.6f, specular = 0.04f;
    const auto schlick = [](float cosine) { return std::pow(1 - cosine, 5.f); };
    const vec3 halfway = glm::normalize(sun + view);
    const float nl = glm::dot(n, sun), nv = glm::dot(n, view), nh = glm::dot(n, halfway);
    const float alpha = roughness * roughness;
    const float d = nh * nh * (alpha * alpha - 1) + 1;
    const float masking = 0.5f / ((1 - alpha) * 2 * nl * nv + alpha * (nl + nv));
    const float highlight = alpha * alpha / (d * d) * masking * nl *
                            (specular + (1 - specular) * schlick(glm::dot(halfway, view)));
    const float mirror = specular + (1 - roughness - specular) * schlick(nv);
    return albedo * (sunLight * nl + skyLight(n)) + sunLight * highlight +
           mirror * skyLight(glm::reflect(-view, n));
}

/// As the picture holds it: tone curve, then sRGB's own curve.
vec3 onScreen(const vec3& light) {
    vec3 result;
    for (int i = 0; i < 3; ++i) {
        const float x = 0.8f * light[i];
        const float y = x * (2.4f * x + 0.12f) / (x * (2.4f * x + 0.62f) + 0.17f);
        result[i] = 255 * (y <= 0.0031308f ? 12.92f * y : 1.055f * std::pow(y, 1 / 2.4f) - 0.055f);
    }
    return result;
}

}  // namespace

TEST_CASE("A plain surface in the sun has the colour that its light gives", "[surface]") {
    for (const Vec3& colour : {Vec3(0.4, 0.2, 0.1), Vec3(0.02, 0.5, 0.9), Vec3(0, 0, 0)}) {
        CAPTURE(colour.transpose());
        WorldDescription description = wallDescription();
        description.materials[0].colour = colour;
        const World world(description);
        for (const render::DrawnMesh mesh :
             {render::DrawnMesh::Simulation, render::DrawnMesh::Display}) {
            const image::Image image =
                picture(world, world.initialState(), frontCamera(), render::DrawStyle::Solid, mesh);
            for (const vec3& p :
                 {vec3(-0.8f, 0.8f, 0.05f), vec3(0.03f, 0.47f, 0.05f), vec3(0.85f, 0.15f, 0.05f)}) {
                const glm::vec2 pixel = project(world, frontCamera(), p);
                const vec3 seen =
                    colourAt(image, static_cast<int>(pixel.x), static_cast<int>(pixel.y));
                const vec3 view = glm::normalize(vec3(0, 0.5f, 3) - p);
                const vec3 expected =
                    onScreen(sunlit(vec3(colour[0], colour[1], colour[2]), {0, 0, 1}, view));
                CAPTURE(p.x, seen.r, seen.g, seen.b, expected.r, expected.g, expected.b);
                for (int i = 0; i < 3; ++i) CHECK(std::abs(seen[i] - expected[i]) <= 2);
            }
        }
    }
}

TEST_CASE("Mortar lies where bricks meet, and nowhere else", "[surface]") {
    const WorldDescription description = wallOf("brick", {1.6, 0.8, 0.1});
    const World world(description);
    const Material& brick = description.materials[0];
    scene::CameraDescription camera;  // two bricks wide: 3 mm per pixel
    camera.position = {0.1, 0.45, 0.75};
    camera.target = {0.1, 0.45, 0};
    const image::Image image = picture(world, world.initialState(), camera);
    const auto meet = [&](const Vec3& p, double within) {
        for (const Vec3& way : {Vec3(within, 0, 0), Vec3(0, within, 0)})
            if (clusterOf(brick, p - way, 1) != clusterOf(brick, p + way, 1)) return true;
        return false;
    };
    const double pixel = 0.7 * 2 * std::tan(0.3926990817) / kHeight;
    int joints = 0, grey = 0, faces = 0, red = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Vec3 p(0.1 + 0.8 + pixel * (x + 0.5 - 0.5 * kWidth),
                         0.45 - pixel * (y + 0.5 - 0.5 * kHeight), 0.1);
            const vec3 colour = colourAt(image, x, y);
            const bool isRed = colour.r > 1.35f * colour.g;
            if (meet(p, 0.002)) {
                ++joints;
                grey += !isRed;
            } else if (!meet(p, 0.014)) {
                ++faces;
                red += isRed;
            }
        }
    CHECK(joints > 1000);
    CHECK(faces > 20000);
    CHECK(grey > 0.95 * joints);
    CHECK(red > 0.98 * faces);
}

TEST_CASE("On every face of a wall, mortar lies where the bricks that it bounds meet",
          "[surface]") {
    // All of its faces but front and back lie exactly where bricks meet.
    WorldDescription description = wallOf("brick", {1.6, 0.8, 0.2});
    description.bodies[0].cells[2] = 2;
    const World world(description);
    const Material& brick = description.materials[0];
    const Body& body = world.bodies()[0];
    const Vec3 size = description.bodies[0].size, middle = body.origin + size / 2;
    for (const render::DrawnMesh mesh : {render::DrawnMesh::Simulation, render::DrawnMesh::Display})
        for (int face = 0; face < 6; ++face) {
            const int axis = face >> 1;
            Vec3 outwards = Vec3::Zero();
            outwards[axis] = face & 1 ? 1 : -1;
            CAPTURE(mesh, outwards.transpose());
            scene::CameraDescription camera;
            camera.target = middle + 0.5 * size[axis] * outwards;
            camera.position = camera.target + 0.7 * outwards;
            camera.target += Vec3(0.01, 0.01, 0.01);  // no pixel's centre lies on a joint's edge
            const image::Image image =
                picture(world, world.initialState(), camera, render::DrawStyle::Solid, mesh);
            const glm::mat4 back =
                glm::inverse(render::makeCamera(camera, static_cast<float>(kWidth) / kHeight,
                                                render::sceneBounds(world))
                                 .viewProjection());
            // Of the face, from the body's origin; nothing where the pixel shows none of it.
            const auto placeAt = [&](int x, int y) -> std::optional<Vec3> {
                const glm::vec2 centre(static_cast<float>(2 * x + 1) / kWidth,
                                       static_cast<float>(2 * y + 1) / kHeight);
                const glm::vec4 seen = back * glm::vec4(centre.x - 1, 1 - centre.y, 0.5f, 1);
                const Vec3 way = Vec3(seen.x, seen.y, seen.z) / double{seen.w} - camera.position;
                const double far =
                    (middle[axis] + 0.5 * size[axis] * outwards[axis] - camera.position[axis]) /
                    way[axis];
                const Vec3 place = camera.position + far * way - body.origin;
                const Vec3 rim = Vec3::Constant(0.015);
                Vec3 low = rim, high = size - rim;
                low[axis] = -1;
                high[axis] = size[axis] + 1;
                if ((place.array() < low.array()).any() || (place.array() > high.array()).any())
                    return std::nullopt;
                return place;
            };
            const auto meet = [&](const Vec3& inside, double within) {
                for (int along = 0; along < 3; ++along) {
                    if (along == axis) continue;
                    Vec3 way = Vec3::Zero();
                    way[along] = within;
                    if (clusterOf(brick, inside - way, 1) != clusterOf(brick, inside + way, 1))
                        return true;
                }
                return false;
            };
            int joints = 0, grey = 0, faces = 0, red = 0;
            for (int y = 0; y < kHeight; ++y)
                for (int x = 0; x < kWidth; ++x) {
                    const auto place = placeAt(x, y);
                    if (!place) continue;
                    const Vec3 inside = *place - 0.001 * outwards;
                    const vec3 colour = colourAt(image, x, y);
                    const bool isRed = colour.r > 1.35f * colour.g;
                    if (meet(inside, 0.002)) {
                        ++joints;
                        grey += !isRed;
                    } else if (!meet(inside, 0.014)) {
                        ++faces;
                        red += isRed;
                    }
                }
            CAPTURE(joints, grey, faces, red);
            CHECK(joints > 100);
            CHECK(faces > 5000);
            // As above: a ragged edge may reach a pixel further.
            CHECK(grey > 0.95 * joints);
            CHECK(red > 0.98 * faces);
        }
}

TEST_CASE("What is seen of a material does not hang on how a place is rounded", "[surface][long]") {
    // Where a wall stands rounds all its places otherwise, and is all that differs: the sun and the
    // sky are far, and there is no ground.
    for (const scene::PresetInfo& preset : scene::materialPresets()) {
        std::vector<image::Image> pictures[2];
        for (const bool elsewhere : {false, true}) {
            const Vec3 at = elsewhere ? Vec3(0.37, 0, 0.73) : Vec3(0, 0, 0);
            WorldDescription description = wallOf(preset.name, {1.6, 0.8, 0.2});
            description.bodies[0].position = at;
            const World world(description);
            Painter painter(world);
            for (const double side : {1.0, -1.0})
                for (const render::DrawnMesh mesh :
                     {render::DrawnMesh::Simulation, render::DrawnMesh::Display})
                    for (const bool broken : {false, true}) {
                        scene::CameraDescription
                            camera;  // a corner, and the three faces that meet there
                        camera.target = at + Vec3(side * 0.7, 0.4 + side * 0.3, 0);
                        camera.position = camera.target + side * Vec3(0.4, 0.5, 0.6);
                        const State state = broken ? burst(world) : world.initialState();
                        render::RenderSettings settings;
                        settings.mesh = mesh;
                        pictures[elsewhere].push_back(painter.picture(state, camera, settings));
                    }
        }
        for (std::size_t i = 0; i < pictures[0].size(); ++i) {
            CAPTURE(preset.name, i);
            // Single pixels at the edges of pieces may be of another piece.
            CHECK(differing(pictures[0][i], pictures[1][i], 16) <= 3);
        }
    }
}

TEST_CASE("A joint as narrow as a pixel is as dark wherever pixels begin", "[surface]") {
    // Straight from the front, so that pixels lie alike along the whole of a bed joint: a bevel
    // seen at their centres alone would darken it in some rows of them and not in others.
    const World world(wallOf("brick", {1.6, 0.8, 0.1}));
    const Vec3 joint(0, 0.4, 0.05);
    const double far = 3, pixel = far * 2 * std::tan(0.3926990817) / kHeight;  // 12 mm
    float least = 1000, most = 0;
    constexpr int kPhases = 8;
    for (int phase = 0; phase < kPhases; ++phase) {
        scene::CameraDescription camera;
        camera.target = joint + Vec3(0, pixel * phase / kPhases, 0);
        camera.position = camera.target + Vec3(0, 0, far);
        const image::Image image = picture(world, world.initialState(), camera);
        const vec3 mean = meanColour(image, {120, kHeight / 2 - 4}, {200, kHeight / 2 + 5});
        least = std::min(least, mean.r + mean.g + mean.b);
        most = std::max(most, mean.r + mean.g + mean.b);
    }
    CAPTURE(least, most);
    // It varies by 0.7 %, as bricks around it do; with bevels seen at pixels' centres by 4.4 %.
    CHECK(most < 1.02f * least);
}

TEST_CASE("A texture moves with its wall", "[surface]") {
    for (const char* material : {"wood", "planks", "brick", "concrete", "rubber"}) {
        CAPTURE(material);
        const World world(wallOf(material));
        const image::Image still = picture(world, world.initialState(), frontCamera());
        // By seven pixels in the plane of its front, which is 2.95 m away.
        const double pixel = 2.95 * 2 * std::tan(0.3926990817) / kHeight;
        const image::Image moved = picture(world, shifted(world, {7 * pixel, 0, 0}), frontCamera());
        const auto difference = [&](int by) {
            double sum = 0;
            int count = 0;
            for (int y = 70; y < 130; ++y)
                for (int x = 100; x < 220; ++x, ++count)
                    sum += glm::length(colourAt(moved, x + by, y) - colourAt(still, x, y));
            return sum / count;
        };
        CHECK(difference(7) < 1.5);
        CHECK(difference(0) > 2 * difference(7));
    }
}

TEST_CASE("What a break bares looks different from the outside", "[surface]") {
    // The face at x = 0 ends a wall, or is bared in the middle of one twice as long.
    scene::CameraDescription camera;
    camera.position = {1.2, 0.5, 0};
    camera.target = {0, 0.5, 0};
    for (const char* material : {"wood", "concrete", "brick"}) {
        CAPTURE(material);
        WorldDescription ending = wallOf(material, {1, 1, 0.4}), breaking = ending;
        ending.bodies[0].position = {-0.5, 0, 0};
        breaking.bodies[0].size[0] = 2;
        breaking.bodies[0].cells[0] *= 2;
        const World whole(ending), broken(breaking);
        State state = broken.initialState();
        const Body& body = broken.bodies()[0];
        const int half = body.cells[0] / 2;
        for (int y = 0; y < body.cells[1]; ++y) {
            state.damage[kBondsPerCell * body.cellAt({half - 1, y, 0})] = 1;
            for (int x = half; x < 2 * half; ++x)
                for (int corner = 0; corner < kCorners; ++corner)
                    state.displacement[kCorners * body.cellAt({x, y, 0}) + corner] = {0, -500, 0};
        }
        const glm::vec2 low = project(whole, camera, {0, 0.9f, 0.15f});
        const glm::vec2 high = project(whole, camera, {0, 0.1f, -0.15f});
        const vec3 outside = meanColour(picture(whole, whole.initialState(), camera), low, high);
        const vec3 inside = meanColour(picture(broken, state, camera), low, high);
        CAPTURE(outside.r, outside.g, outside.b, inside.r, inside.g, inside.b);
        CHECK(glm::length(inside - outside) > 12);
        if (material == std::string("wood")) CHECK(inside.g > outside.g + 10);
    }
}
