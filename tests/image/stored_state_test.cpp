// States that pictures are drawn from, as files.
#include "image/stored_state.hpp"

#include "catch.hpp"
#include "files/write_file.hpp"
#include "scene/scene.hpp"
#include "support/test_folder.hpp"

using namespace sunder;
using namespace sunder::core;
using Catch::Contains;

namespace {

/// Nothing in it is as it was at first.
State moved(const World& world) {
    State state = world.initialState();
    state.step = 1234567890123;
    for (int node = 0; node < world.nodeCount(); ++node) {
        const auto x = static_cast<float>(node);
        state.displacement[node] = {0.1f * x, -1e-7f * x, 1e-30f};
    }
    for (std::size_t bond = 0; bond < state.damage.size(); bond += 3)
        if (state.damage[bond] < kNoBond) state.damage[bond] = 1.5;
    for (ObjectState& object : state.objects) {
        object.present = !object.present;
        object.position = {1, 2.5f, -1e6f};
        object.orientation.coeffs() = {0.5, -0.5, 0.5, -0.5};
    }
    return state;
}

std::string refusal(std::string_view bytes, const World& world) {
    try {
        decodeState(bytes, world, "x.state");
    } catch (const StateError& error) {
        return error.what();
    }
    return "none";
}

}  // namespace

TEST_CASE("a stored state has all that is drawn, in single precision") {
    const World world(scene::loadScene("wrecking-ball").world);
    const State before = moved(world);
    const TestFolder folder;
    writeState(folder.path() / "states" / "a.state", before);
    const State after = readState(folder.path() / "states" / "a.state", world);
    CHECK(after.step == before.step);
    CHECK((after.displacement == before.displacement));
    int broken = 0, absent = 0;
    for (std::size_t bond = 0; bond < before.damage.size(); ++bond) {
        REQUIRE((after.damage[bond] < 1) == (before.damage[bond] < 1));
        REQUIRE((after.damage[bond] == kNoBond) == (before.damage[bond] == kNoBond));
        broken += after.damage[bond] == 1;
        absent += after.damage[bond] == kNoBond;
    }
    CHECK(broken > 100);
    CHECK(absent > 100);
    REQUIRE(after.objects.size() == 1);
    CHECK(after.objects[0].present == before.objects[0].present);
    CHECK(after.objects[0].position == before.objects[0].position);
    CHECK(after.objects[0].orientation.coeffs() == before.objects[0].orientation.coeffs());
}

TEST_CASE("a damaged state, or one of another world, is refused") {
    const World world(scene::loadScene("wood-thesis").world);
    const std::string whole = encodeState(moved(world));
    REQUIRE(refusal(whole, world) == "none");
    // Wherever it is cut and whichever bit of it is another. The step is not part of a picture.
    for (std::size_t size = 0; size < whole.size(); size += 7)
        REQUIRE_THAT(refusal(whole.substr(0, size), world), Contains("x.state: "));
    CHECK_THAT(refusal(whole + '\0', world), Contains("damaged"));
    for (std::size_t byte = 0; byte < whole.size(); byte += 5) {
        if (byte >= 20 && byte < 32) continue;
        std::string flipped = whole;
        flipped[byte] = static_cast<char>(flipped[byte] ^ 0x40);
        INFO(byte);
        REQUIRE(refusal(flipped, world) != "none");
    }
    CHECK_THAT(refusal(whole, World(scene::loadScene("wood").world)),
               Contains("another world") && Contains("432 nodes"));
    CHECK_THAT(refusal("PNG", world), Contains("not a stored state"));
    CHECK_THROWS_AS(readState("no/such.state", world), StateError);
}
