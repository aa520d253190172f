#include "app/support/program.hpp"
#include "app/support/scenes.hpp"
#include "catch.hpp"

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("App: a scene that is not there is one sentence and exit code 2, and leaves nothing") {
    const Workplace place;
    place.write("folder.txt", "");
    struct Case {
        std::string scene;
        std::vector<std::string> said;
    };
    for (const Case& c : {Case{"wodo", {"'wodo'", "presets: ", "wood-thesis", "cantilever"}},
                          Case{"missing.toml", {"'missing.toml'"}},
                          Case{"./missing", {"'./missing'"}}, Case{"./", {"'./'", "folder"}}}) {
        const Result result = place.run({"run", c.scene}, kNoGl);
        checkRefused(result, 2, c.said);
        CHECK(place.contents() == std::set<std::string>{"folder.txt"});
    }
}

TEST_CASE("App: a bad scene file is one sentence with file and line, and leaves nothing") {
    // Lines 1 to 5 are frames and the material, 6 to 10 the body, 11 its position.
    const std::string& good = scenes::kFalling;
    struct Case {
        std::string text;
        std::vector<std::string> said;
    };
    const std::vector<Case> cases{
        {replaced(good, "strength = 1e12", "strength = = 1"), {"bad.toml:4:"}},
        {"[[body\n", {"bad.toml:1:"}},
        {"", {"no body"}},
        {replaced(good, "damping", "dampening"), {"bad.toml:5:", "dampening"}},
        {good + "colour = 'red'\n", {"bad.toml:12:", "colour"}},
        {replaced(good, "damping = 0", "density = -1"), {"bad.toml:5:", "density", "-1"}},
        {replaced(good, "damping = 0", "poisson_ratio = 0.5"),
         {"bad.toml:5:", "poisson_ratio", "0.5"}},
        {replaced(good, "damping = 0", "density = nan"), {"bad.toml:5:", "density"}},
        {replaced(good, "[6, 4, 1]", "[6, 0, 1]"), {"bad.toml:10:", "cells", "0"}},
        {replaced(good, "[6, 4, 1]", "[6, 4]"), {"bad.toml:10:", "cells"}},
        {replaced(good, "[6, 4, 1]", "[4000, 4000, 4000]"), {"bad.toml:10:", "cells", "16777216"}},
        {replaced(good, "'soft'\n", "'sofd'\n"), {"bad.toml:8:", "'sofd'", "soft"}},
        {replaced(good, "frames = 5", "frames = 0"), {"bad.toml:1:", "frames"}},
        {replaced(good, "[0, 1, 0]", "[0, -0.3, 0]"),
         {"bad.toml:11:", "position", "'wall'", "0.3 m below the ground"}},
    };
    for (const Case& c : cases) {
        const Workplace place;
        place.write("bad.toml", c.text);
        const Result result = place.run({"run", "bad.toml"}, kNoGl);
        checkRefused(result, 2, c.said);
        CHECK(place.contents() == std::set<std::string>{"bad.toml"});
        CHECK(place.read("bad.toml") == c.text);
    }
}

TEST_CASE(
    "App: where a file stands no folder can be made: exit code 2, and the file is as it was") {
    const Workplace place;
    place.write("ok.toml", scenes::kFalling);
    place.write("taken", "mine");
    for (const std::string out : {"taken", "taken/deeper"}) {
        const Result result = place.run({"run", "ok.toml", "--solver", "reference", "--frames-png",
                                         "0", "--out", out, "--json", "a.json", "--state", "a.vtu"},
                                        kNoGl);
        checkRefused(result, 2, {"'" + out + "'"});
        CHECK(place.contents() == std::set<std::string>{"ok.toml", "taken"});
        CHECK(place.read("taken") == "mine");
    }
}

TEST_CASE("App: without an OpenGL context one sentence and exit code 3, and nothing is left") {
    const Workplace place;
    place.write("ok.toml", scenes::kFalling);
    // The solver needs it, or only the pictures do.
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"run", "ok.toml", "--frames-png", "0"},
          std::vector<std::string>{"run", "ok.toml", "--solver", "reference"}}) {
        const Result result = place.run(arguments, kNoGl);
        checkRefused(result, 3, {"99"});
        CHECK(place.contents() == std::set<std::string>{"ok.toml"});
    }
}
