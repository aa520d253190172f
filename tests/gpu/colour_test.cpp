// Walls coloured by what happens in them: values, legend, pixels.
#include <algorithm>
#include <set>
#include <tuple>

#include "catch.hpp"
#include "gpu/pictures.hpp"
#include "gpu/test_context.hpp"
#include "image/srgb.hpp"
#include "render/cell_colours.hpp"
#include "render/colour_map.hpp"
#include "render/legend.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

using Rgb = std::array<int, 3>;

Rgb rgb(const glm::vec3& linear) {
    return {image::srgbByte(linear.r), image::srgbByte(linear.g), image::srgbByte(linear.b)};
}

Rgb at(const image::Image& image, int x, int y) {
    const std::uint8_t* p = image.pixels.data() + 3 * (std::ptrdiff_t{image.width} * y + x);
    return {p[0], p[1], p[2]};
}

int distance(const Rgb& a, const Rgb& b) {
    int most = 0;
    for (int i = 0; i < 3; ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

/// A wall that no step limits, whose stress is Young's modulus times strain.
WorldDescription softWall(FractureMode fracture) {
    WorldDescription description = wallDescription();
    Material& material = description.materials[0];
    material.youngModulus = 1e6;
    material.poissonRatio = 0;
    material.fracture = fracture;
    material.strength = {2e4, 4e4, 1e4};
    material.maxStress = 8e4;
    return description;
}

/// Strained along x by `strain` where x > 0, at rest elsewhere.
State stretched(const World& world, double strain) {
    State state = world.initialState();
    for (int node = 0; node < world.nodeCount(); ++node)
        state.displacement[node] = {strain * std::max(0.0, world.restPosition(node)[0]), 0, 0};
    return state;
}

/// The body's cells (0, y, 0), and with them those to the left, leave their neighbours.
void cutColumn(const World& world, State& state, int x) {
    const Body& wall = world.bodies()[0];
    for (int y = 0; y < wall.cells[1]; ++y)
        state.damage[kBondsPerCell * wall.cellAt({x, y, 0})] = 1;
}

glm::vec3 colourOf(const render::CellColours& colours, const World& world, const IVec3& cell) {
    return colours.colours()[world.bodies()[0].cellAt(cell)];
}

/// Draws the wall in these colours, seen from straight in front.
image::Image painted(const World& world, const State& state, const render::CellColours* colours,
                     render::DrawStyle style = render::DrawStyle::Solid) {
    render::RenderSettings settings;
    settings.style = style;
    settings.colours = colours;
    return picture(world, state, frontCamera(), settings);
}

/// In the middle of a cell's front face.
Rgb pixelOf(const image::Image& image, const World& world, int x, int y) {
    const glm::vec2 p = project(world, frontCamera(),
                                {-1 + 0.25f * (static_cast<float>(x) + 0.5f),
                                 0.25f * (static_cast<float>(y) + 0.5f), 0.05f});
    return at(image, static_cast<int>(p.x), static_cast<int>(p.y));
}

}  // namespace

TEST_CASE("A stretched cell has the colour of Young's modulus times strain", "[colour]") {
    // The scale ends at the highest strength.
    for (const auto& [fracture, end] :
         {std::pair{FractureMode::Bond, 4e4}, {FractureMode::Cell, 8e4}}) {
        const World world(softWall(fracture));
        REQUIRE(!world.laws()[0].limited);
        render::CellColours colours(world);
        for (const double strain : {0.001, 0.01, 0.03, 0.5}) {
            CAPTURE(end, strain);
            colours.update(stretched(world, strain), render::WallColour::Stress);
            CHECK(colours.key().end == Approx(end));
            const glm::vec3 right = colourOf(colours, world, {5, 2, 0});
            CHECK(glm::length(right - render::mapColour(1e6 * strain / end)) < 1e-3);
            CHECK(glm::length(colourOf(colours, world, {2, 2, 0}) - render::mapColour(0)) < 1e-3);
        }
    }
}

TEST_CASE("Where nothing breaks, the scale of stress grows in steps and never shrinks",
          "[colour]") {
    const World world(softWall(FractureMode::None));
    render::CellColours colours(world);
    for (const auto& [strain, end] :
         {std::pair{0.0, 100.0}, {0.001, 1e3}, {0.011, 2e4}, {0.001, 2e4}, {0.03, 5e4}}) {
        CAPTURE(strain);
        colours.update(stretched(world, strain), render::WallColour::Stress);
        CHECK(colours.key().end == Approx(end));
        CHECK(glm::length(colourOf(colours, world, {6, 1, 0}) -
                          render::mapColour(1e6 * strain / end)) < 1e-3);
    }
}

TEST_CASE("A cell has the colour of its speed", "[colour]") {
    const World world(softWall(FractureMode::Bond));
    const Body& wall = world.bodies()[0];
    State state = world.initialState();
    const auto move = [&](const IVec3& cell, const Vec3& velocity) {
        std::fill_n(state.velocity.begin() + kCorners * wall.cellAt(cell), kCorners, velocity);
    };
    move({1, 1, 0}, {0, 3, -4});
    move({2, 1, 0}, {-13, 0, 0});
    // Spins about its middle, which stays.
    for (int corner = 0; corner < kCorners; ++corner)
        state.velocity[kCorners * wall.cellAt({3, 1, 0}) + corner] = {0, 0,
                                                                      corner & 1 ? 5.0 : -5.0};
    render::CellColours colours(world);
    colours.update(state, render::WallColour::Speed);
    CHECK(colours.key().end == Approx(20));
    CHECK(glm::length(colourOf(colours, world, {1, 1, 0}) - render::mapColour(5. / 20)) < 1e-4);
    CHECK(glm::length(colourOf(colours, world, {2, 1, 0}) - render::mapColour(13. / 20)) < 1e-4);
    CHECK(glm::length(colourOf(colours, world, {3, 1, 0}) - render::mapColour(0)) < 1e-4);
    colours.update(world.initialState(), render::WallColour::Speed);
    CHECK(colours.key().end == Approx(20));
}

TEST_CASE("Each piece has a colour of its own and keeps it", "[colour]") {
    const World world(softWall(FractureMode::Bond));
    State state = world.initialState();
    render::CellColours colours(world);
    const auto colour = [&](int x) { return colourOf(colours, world, {x, 3, 0}); };
    colours.update(state, render::WallColour::Piece);
    CHECK(colours.key().pieces == 1);
    CHECK(colour(0) == render::kNeutralColour);

    cutColumn(world, state, 4);
    cutColumn(world, state, 5);
    colours.update(state, render::WallColour::Piece);
    CHECK(colours.key().pieces == 3);
    CHECK(colour(0) == render::kNeutralColour);  // 5 of 8 columns
    CHECK(colour(4) == render::kNeutralColour);
    const glm::vec3 five = colour(5), right = colour(6);
    CHECK(colour(7) == right);
    CHECK(distance(rgb(five), rgb(right)) > 40);
    CHECK(distance(rgb(five), rgb(render::kNeutralColour)) > 40);

    cutColumn(world, state, 1);
    colours.update(state, render::WallColour::Piece);
    CHECK(colours.key().pieces == 4);
    CHECK(colour(5) == five);
    CHECK(colour(6) == right);
    CHECK(colour(2) == render::kNeutralColour);  // 3 columns, now the most
    CHECK(colour(1) != render::kNeutralColour);

    // All apart: one colour each but for the one that counts as the largest.
    for (double& damage : state.damage)
        if (damage != kNoBond) damage = 1;
    colours.update(state, render::WallColour::Piece);
    std::set<std::tuple<int, int, int>> seen;
    for (const glm::vec4& c : colours.colours()) {
        const Rgb bytes = rgb(c);
        seen.insert({bytes[0], bytes[1], bytes[2]});
    }
    CHECK(seen.size() == std::size_t(world.cellCount()));
}

TEST_CASE("The colours of a thousand pieces are a thousand", "[colour]") {
    std::set<std::tuple<int, int, int>> seen;
    for (int i = 0; i < 1000; ++i) {
        const Rgb bytes = rgb(render::distinctColour(i));
        seen.insert({bytes[0], bytes[1], bytes[2]});
        CHECK(distance(bytes, rgb(render::distinctColour(i + 1))) > 40);
    }
    CHECK(seen.size() > 990);  // those out of sRGB's gamut are cut to it
}

TEST_CASE("The colour map grows lighter all the way", "[colour]") {
    const auto luminance = [](double value) {
        return glm::dot(render::mapColour(value), glm::vec3(0.2126f, 0.7152f, 0.0722f));
    };
    for (int i = 0; i < 100; ++i) CHECK(luminance(i / 100.) < luminance((i + 1) / 100.));
    CHECK(rgb(render::mapColour(0)) == Rgb{0x44, 0x01, 0x54});
    CHECK(rgb(render::mapColour(0.5)) == Rgb{0x21, 0x91, 0x8c});
    CHECK(rgb(render::mapColour(1)) == Rgb{0xfd, 0xe7, 0x25});
    CHECK(render::mapColour(-3) == render::mapColour(0));
    CHECK(render::mapColour(7) == render::mapColour(1));
    CHECK(render::mapColour(std::nan("")) == render::mapColour(0));
}

TEST_CASE("In the sun a wall's pixels have the legend's colours", "[colour]") {
    const World world(softWall(FractureMode::Bond));
    const State state = stretched(world, 0.02);
    render::CellColours colours(world);
    colours.update(state, render::WallColour::Stress);
    const image::Image image = painted(world, state, &colours);
    CHECK(distance(pixelOf(image, world, 5, 2), rgb(render::mapColour(0.5))) <= 3);
    CHECK(distance(pixelOf(image, world, 1, 2), rgb(render::mapColour(0))) <= 3);

    // The other styles show the colours too.
    const image::Image overlay = painted(world, state, &colours, render::DrawStyle::Overlay);
    CHECK(distance(pixelOf(overlay, world, 1, 2), rgb(render::mapColour(0))) < 40);
    CHECK(overlay.pixels != image.pixels);
    const image::Image wire = painted(world, state, &colours, render::DrawStyle::Wireframe);
    CHECK(differing(wire, painted(world, state, nullptr, render::DrawStyle::Wireframe), 40) > 100);
}

TEST_CASE("With the materials' colours nothing is painted", "[colour]") {
    const World world(softWall(FractureMode::Bond));
    render::CellColours colours(world);
    colours.update(world.initialState(), render::WallColour::Material);
    const image::Image without = painted(world, world.initialState(), nullptr);
    image::Image image = painted(world, world.initialState(), &colours);
    CHECK(image.pixels == without.pixels);
    render::drawLegend(image, colours.key());
    CHECK(image.pixels == without.pixels);
}

TEST_CASE("A renderer paints in one picture and not in the next", "[colour]") {
    testContext();
    const World world(softWall(FractureMode::Bond));
    const gpu::WorldBuffers buffers(world);
    gpu::StateUpload upload(world);
    render::Renderer renderer(world, buffers);
    render::CellColours colours(world);
    render::RenderSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    const auto draw = [&](render::WallColour colour) {
        colours.update(world.initialState(), colour);
        settings.colours = &colours;
        return renderer.draw(upload.upload(world.initialState()), frontCamera(), settings);
    };
    const image::Image plain = draw(render::WallColour::Material),
                       speed = draw(render::WallColour::Speed);
    CHECK(pixelOf(speed, world, 3, 2) != pixelOf(plain, world, 3, 2));
    CHECK(draw(render::WallColour::Material).pixels == plain.pixels);
    const image::Image piece = draw(render::WallColour::Piece);
    CHECK(distance(pixelOf(piece, world, 3, 2), rgb(render::kNeutralColour)) <= 3);
    CHECK(draw(render::WallColour::Speed).pixels == speed.pixels);
}

TEST_CASE("A legend runs through the colours from left to right", "[colour]") {
    for (const render::WallColour colour :
         {render::WallColour::Stress, render::WallColour::Speed}) {
        image::Image image{640, 360, std::vector<std::uint8_t>(3 * 640 * 360, 100)};
        render::drawLegend(image, {colour, 2e6, 0});
        // Scale 2: 240 pixels from the left margin of 8; 14 high, above 6 and a line of numbers.
        const int y = 360 - 8 - 18 - 6 - 7;
        for (const double share : {0.005, 0.25, 0.5, 0.75, 0.995}) {
            CAPTURE(share);
            CHECK(distance(at(image, 8 + static_cast<int>(240 * share), y),
                           rgb(render::mapColour(share))) <= 3);
        }
        CHECK(at(image, 300, y) == Rgb{100, 100, 100});
        CHECK(at(image, 400, 100) == Rgb{100, 100, 100});
    }
    // Numbers and units differ where what they say does.
    const auto drawn = [](const render::ColourKey& key) {
        image::Image image{640, 360, std::vector<std::uint8_t>(3 * 640 * 360, 100)};
        render::drawLegend(image, key);
        return image.pixels;
    };
    CHECK(drawn({render::WallColour::Stress, 2e6, 0}) !=
          drawn({render::WallColour::Stress, 2e3, 0}));
    CHECK(drawn({render::WallColour::Stress, 2e6, 0}) !=
          drawn({render::WallColour::Stress, 5e6, 0}));
    CHECK(drawn({render::WallColour::Stress, 2e6, 7}) ==
          drawn({render::WallColour::Stress, 2e6, 0}));
    CHECK(drawn({render::WallColour::Piece, 0, 7}) != drawn({render::WallColour::Piece, 0, 8}));
}
