// What mistakes in scene files are answered with: one sentence each.
#include <string>
#include <vector>

#include "catch.hpp"
#include "scene/scene.hpp"
#include "support/scene_text.hpp"

using namespace sunder;

namespace {

/// kBody with an event on lines 6 to 12; tests add line 13 and on.
const std::string kEvent = kBody +
                           "[[event]]\ntime = 0.1\nkind = 'impulse'\nbody = 'wall'\n"
                           "point = [0, 1, 0]\nradius = 0.3\nvector = [0, 0, -1]\n";

}  // namespace

TEST_CASE("A mistake in a scene becomes one sentence", "[scene]") {
    const std::vector<Bad> cases{
        // Not TOML, or not a scene.
        {"frames = 120\nframes = [1", {"walls.toml:2: not valid TOML: "}},
        {"title = 'a'\ntitle = 'b'\n", {"walls.toml:2: not valid TOML: "}},
        {"title = '\xff'\n", {"walls.toml:1: not valid TOML: "}},
        {"", {"walls.toml: the scene has no body", "[[body]]"}},
        {"frames = 3\n", {"walls.toml: the scene has no body"}},
        // Unknown keys, at every level.
        {"\n\nfrmaes = 3\n",
         {"walls.toml:3: unknown key 'frmaes' in the scene; did you mean 'frames'? (known: title, "
          "frames,"}},
        {"[solver]\nsteps = 3\n", {"walls.toml:2: unknown key 'steps' in solver", "substeps"}},
        {"[ground]\nfricton = 3\n", {"walls.toml:2: unknown key", "did you mean 'friction'?"}},
        {"[camera]\nfov = 3\n", {"walls.toml:2: unknown key 'fov' in camera", "field_of_view"}},
        {"[material.x]\nyoungs_modulus = 3\n",
         {"walls.toml:2: unknown key 'youngs_modulus' in material 'x'",
          "did you mean 'young_modulus'?"}},
        {kBody + "sise = 3\n",
         {"walls.toml:6: unknown key 'sise' in body 1; did you mean 'size'?"}},
        {kBody + "[[body.region]]\nfrom = [0,0,0]\nuntil = 1\n",
         {"walls.toml:8: unknown key 'until' in region 1 of body 1"}},
        {kEvent + "force = 1\n", {"walls.toml:13: unknown key 'force' in event 1"}},
        // A misspelt key is the mistake, not the missing one.
        {"[[body]]\nname = 'a'\nmaterial = 'wood'\nsice = [1,1,1]\ncells = [1,1,1]\n",
         {"walls.toml:4: unknown key 'sice'", "did you mean 'size'?"}},
        // Scene-wide numbers.
        {"frames = 0\n" + kBody,
         {"walls.toml:1: frames must be a whole number from 1 to 1000000, not 0"}},
        {"frames = 1.5\n" + kBody, {"walls.toml:1: frames must be a whole number", "not 1.5"}},
        {"frames = nan\n" + kBody, {"walls.toml:1: frames must be a whole number", "not nan"}},
        {"frames = '9'\n" + kBody, {"frames must be a whole number", "not the text '9'"}},
        {"frames = 1979-05-27\n" + kBody, {"walls.toml:1: frames", "not a date or time"}},
        {"seed = -1\n" + kBody, {"walls.toml:1: seed must be a whole number from 0", "not -1"}},
        {"title = 3\n" + kBody, {"walls.toml:1: title must be a text in quotes, not 3"}},
        {"title = \"a\\nb\"\n" + kBody, {"walls.toml:1: title must be one line", "'a\\nb'"}},
        {"title = '" + std::string(5000, 'x') + "'\n" + kBody,
         {"walls.toml:1: title must be at most 200 characters long", "xxx…"}},
        {"gravity = -9.81\n" + kBody,
         {"walls.toml:1: gravity must be a list of three numbers, not -9.81"}},
        {"gravity = [0, -9.81]\n" + kBody,
         {"walls.toml:1: gravity must be a list of three", "a list of 2"}},
        {"gravity = [0,\n 'x', 0]\n" + kBody,
         {"walls.toml:2: gravity: number 2 must be a number from -1000 to 1000 m/s²", "'x'"}},
        {"gravity = [0, inf, 0]\n" + kBody, {"walls.toml:1: gravity: number 2", "not inf"}},
        {"solver = 3\n" + kBody,
         {"walls.toml:1: solver must be one table, headed [solver], not 3"}},
        {"[solver]\nsubsteps = 0\n" + kBody,
         {"walls.toml:2: solver: substeps must be a whole number from 1 to 10000, not 0"}},
        {"[solver]\nfracture_interval = 101\n" + kBody,
         {"walls.toml:2: solver: fracture_interval", "101"}},
        {"[ground]\nenabled = 1\n" + kBody,
         {"walls.toml:2: ground: enabled must be true or false, not 1"}},
        {"[ground]\nfriction = -0.1\n" + kBody,
         {"walls.toml:2: ground: friction must be from 0 to 10, not -0.1"}},
        {"[room]\nx = [-2, 2]\n" + kBody,
         {"walls.toml:1: room: z is missing; give [low, high] in m, where the walls stand"}},
        {"[room]\nx = [-2, 0, 2]\n" + kBody,
         {"walls.toml:2: room: x must be a list of two numbers"}},
        {"[room]\nx = [2, -2]\nz = [-1, 1]\n" + kBody,
         {"walls.toml:2: room: x: number 2 must be greater than number 1, 2, not -2"}},
        {"[room]\nx = [-2, 2]\nz = [-1, 1e5]\n" + kBody,
         {"walls.toml:3: room: z: number 2 must be from -10000 to 10000 m, not 100000"}},
        {"[room]\nx = [-2, 2]\nz = [-1, 1]\nfriction = 11\n" + kBody,
         {"walls.toml:4: room: friction must be from 0 to 10, not 11"}},
        {"[room]\nx = [-2, 2]\nz = [-1, 1]\nceiling = 0\n" + kBody,
         {"walls.toml:4: room: ceiling must be", "not 0"}},
        {"[room]\nx = [-2, 2]\nz = [-1, 1]\nheight = 3\n" + kBody,
         {"walls.toml:4: unknown key 'height' in room", "known: x, z, friction, ceiling"}},
        {"[camera]\nposition = [1,1,1]\ntarget = [1,1,1]\n" + kBody,
         {"walls.toml:2: camera: position and target"}},
        {"[camera]\nfield_of_view = 171\n" + kBody,
         {"walls.toml:2: camera: field_of_view must be from 1 to 170 degrees, not 171"}},
        // Bodies.
        {"[body]\nname = 'a'\n",
         {"walls.toml:1: body must be a list of tables, each headed [[body]], not a table"}},
        {"body = [1]\n", {"walls.toml:1: each body must be a table, headed [[body]], not 1"}},
        {"\n[[body]]\nmaterial = 'wood'\n", {"walls.toml:2: body 1: name is missing"}},
        {"[[body]]\nname = 'a'\nmaterial = 'wood'\ncells = [1,1,1]\n",
         {"walls.toml:1: body 1: size is missing; give [x, y, z] in m"}},
        {replaced(kBody, "[3, 2, 0.1]", "[3, 2, 0]"),
         {"walls.toml:4: body 1: size: number 3 must be from 0.001 to 1000 m, not 0"}},
        {replaced(kBody, "[30, 20, 1]", "[30, 0, 1]"),
         {"walls.toml:5: body 1: cells: number 2 must be a whole number from 1", "not 0"}},
        {replaced(kBody, "[30, 20, 1]", "[30, -20, 1]"),
         {"walls.toml:5: body 1: cells: number 2", "not -20"}},
        {replaced(kBody, "[30, 20, 1]", "[]"),
         {"walls.toml:5: body 1: cells must be a list of three", "list of 0"}},
        {replaced(kBody, "[30, 20, 1]", "[4096, 4096, 2]"),
         {"walls.toml:5: body 1: the scene has too many cells", "16777216"}},
        {replaced(kBody, "[30, 20, 1]", "[16777216, 16777216, 16777216]"),
         {"walls.toml:5: body 1: the scene has too many cells"}},
        {replaced(kBody, "'wall'", "''"), {"walls.toml:2: body 1: name must not be empty"}},
        {replaced(kBody, "'wall'", "\"\\u001b[2J\""),
         {"walls.toml:2: body 1: name must be one line", "'\\u001b[2J'"}},
        {kBody + "anchor = 'bottom'\n",
         {"walls.toml:6: body 1: anchor must be a list", "not the text 'bottom'"}},
        {kBody + "anchor = ['botom']\n",
         {"walls.toml:6: body 1: each of anchor must be one of left, right, bottom, top, back, "
          "front",
          "did you mean 'bottom'?"}},
        {kBody + "anchor = ['top', 'top']\n", {"walls.toml:6: body 1: anchor names 'top' twice"}},
        {kBody + kBody, {"walls.toml:7: body 2: there is already a body named 'wall'"}},
        {replaced(kBody, "'wood'", "'wod'"),
         {"walls.toml:3: body 1: material 'wod' is neither a preset nor a file; presets: ",
          "; did you mean 'wood'?", "concrete"}},
        {"[material.mine]\n" + replaced(kBody, "'wood'", "'nine'"),
         {"walls.toml:4: body 1: material 'nine'", "this scene's own: mine",
          "did you mean 'mine'?"}},
        {replaced(kBody, "'wood'", "'nowhere/x.toml'"),
         {"walls.toml:3: body 1: cannot read 'nowhere/x.toml': ", "No such file"}},
        {kBody + "copies = [0, 1, 1]\n",
         {"walls.toml:6: body 1: copies: number 1 must be a whole number from 1"}},
        {kBody + "copies = [2, 1, 1]\n", {"walls.toml:6: body 1: copies needs spacing"}},
        {kBody + "copies = [2, 1, 1]\nspacing = [1, 0, 0]\n",
         {"walls.toml:7: body 1: spacing: number 1 must be at least the body's size, 3 m",
          "not 1"}},
        {kBody + "copies = [9999, 9999, 9999]\nspacing = [9, 9, 9]\n",
         {"walls.toml:6: body 1: the scene has too many bodies", "at most 10000"}},
        {kBody + "copies = [2, 1, 1]\nspacing = [4, 0, 0]\n" +
             replaced(kBody, "'wall'", "'wall 2'"),
         {"walls.toml:9: body 2: there is already a body named 'wall 2'"}},
        // Regions.
        {kBody + "[[body.region]]\nto = [1,1,0]\nempty = true\n",
         {"walls.toml:6: region 1 of body 1: from is missing"}},
        {kBody + "[[body.region]]\nfrom = [0,20,0]\nto = [0,20,0]\nempty = true\n",
         {"walls.toml:7: region 1 of body 1: from: number 2 must be at most 19, not 20",
          "[30, 20, 1] cells"}},
        {kBody + "[[body.region]]\nfrom = [2,0,0]\nto = [1,0,0]\nempty = true\n",
         {"walls.toml:8: region 1 of body 1: to: number 1 must be from 2 (that of from) to 29, not "
          "1"}},
        {kBody + "[[body.region]]\nfrom = [-1,0,0]\nto = [1,0,0]\nempty = true\n",
         {"walls.toml:7: region 1 of body 1: from: number 1", "not -1"}},
        {kBody + "[[body.region]]\nfrom = [0,0,0]\nto = [1,0,0]\n",
         {"walls.toml:6: region 1 of body 1: it has no material", "empty = true"}},
        {kBody + "[[body.region]]\nfrom = [0,0,0]\nto = [1,0,0]\nempty = true\nmaterial = 'wood'\n",
         {"walls.toml:6: region 1 of body 1: it has both a material and empty = true"}},
        {kBody + "region = 1\n",
         {"walls.toml:6: body 1: region must be a list of tables, each headed [[body.region]], not "
          "1"}},
        // Events.
        {replaced(kEvent, "body = 'wall'", "body = 'wal'"),
         {"walls.toml:9: event 1: there is no body 'wal'; bodies: wall; did you mean 'wall'?"}},
        {replaced(kEvent, "'impulse'", "'push'"),
         {"walls.toml:8: event 1: kind must be one of impulse, force, velocity, blast, throw, not "
          "the "
          "text 'push'"}},
        {replaced(kEvent, "'impulse'", "'blast'"),
         {"walls.toml:9: event 1: an event of kind 'blast' has no 'body'; leave it out, or change "
          "kind"}},
        {replaced(replaced(replaced(kEvent, "'impulse'", "'blast'"), "body = 'wall'\n", ""),
                  "vector = [0, 0, -1]\n", ""),
         {"walls.toml:6: event 1: outward is missing; give the speed away from point that it "
          "gives, "
          "in m/s"}},
        {kEvent + "outward = 3\n",
         {"walls.toml:13: event 1: an event of kind 'impulse' has no 'outward'; leave it out, or "
          "change kind"}},
        {replaced(kEvent, "'impulse'", "'force'"),
         {"walls.toml:6: event 1: duration is missing; give how long the force acts, in s"}},
        {replaced(kEvent, "radius = 0.3", "radius = 0"),
         {"walls.toml:11: event 1: radius must be greater than 0 and at most 10000 m, not 0"}},
        {replaced(kEvent, "time = 0.1", "time = -0.1"),
         {"walls.toml:7: event 1: time must be from 0", "not -0.1"}},
        {replaced(kEvent, "[0, 0, -1]", "[0, 0, nan]"),
         {"walls.toml:12: event 1: vector: number 3", "N·s, not nan"}},
        {kEvent + "duration = 0\n", {"walls.toml:13: event 1: duration must be greater than 0"}},
        {replaced(kEvent, "point = [0, 1, 0]\n", ""),
         {"walls.toml:6: event 1: point is missing; give [x, y, z] in m"}},
        // Materials of the scene.
        {"material = 'wood'\n" + kBody,
         {"walls.toml:1: material must be tables, each headed [material.NAME]"}},
        {"[material]\nx = 1\n" + kBody, {"walls.toml:2: material 'x' must be a table"}},
        {"[material.x]\nbase = 'wod'\n" + kBody,
         {"walls.toml:2: material 'x': material 'wod' is neither", "'wood'?"}},
        {"[material.x]\nbase = 'x'\n" + kBody,
         {"walls.toml:2: material 'x': material 'x' is neither"}},
        {"[material.x]\nbase = 'y'\n[material.y]\nbase = 'x'\n" + kBody,
         {"walls.toml:4: material 'y': base 'x' leads back"}},
        {"[material.'a/b']\n" + kBody, {"walls.toml:1: material 'a/b': a material's name must be"}},
        {"[material.x]\ndensity = -5\n" + kBody,
         {"walls.toml:2: material 'x': density must be", "kg/m³, not -5"}},
    };
    for (const Bad& bad : cases) {
        INFO("input: " << bad.text.substr(0, 400));
        checkParts(sceneError(bad.text), bad.parts);
    }
}

TEST_CASE("Hostile files end in a sentence", "[scene]") {
    std::string dots = "a";
    for (int i = 0; i < 1000000; ++i) dots += ".a";
    checkParts(sceneError(dots + " = 1"), {"walls.toml:1: a key has too many parts"});
    checkParts(sceneError("\n[" + dots + "]"), {"walls.toml:2: a key has too many parts"});
    checkParts(sceneError("x = " + std::string(1000000, '[')), {"walls.toml:1: not valid TOML: "});
    checkParts(sceneError(std::string(5u << 20, ' ')),
               {"walls.toml: the text is larger than 4 MiB"});
    std::string many;
    for (int i = 0; i < 10001; ++i) many += "[[body]]\n";
    checkParts(sceneError(many), {"there are 10001 tables [[body]]; at most 10000 are allowed"});
    // Dots in texts and comments are no keys.
    const std::string stops(40, '.');
    CHECK(sceneError("title = \"\\\"" + stops + "\" # " + stops + "\n" + kBody).empty());
    CHECK(sceneError("title = '''" + stops + "'''\n" + kBody).empty());
}
TEST_CASE("A name that leads nowhere lists the presets", "[scene]") {
    checkParts(messageOf([] { scene::loadScene("wod"); }),
               {"scene 'wod' is neither a preset nor a file; presets: ", "cantilever, concrete, ",
                "; did you mean 'wood'?"});
    checkParts(messageOf([] { scene::loadScene(""); }), {"scene '' is neither"});
    checkParts(messageOf([] { scene::loadScene("a\x1b[31m\nb\xff\u202e"); }),
               {R"('a\u001b[31m\nb\xff\u202e')"});
    checkParts(messageOf([] { scene::loadScene(std::string(100000, 'a')); }), {"aaa…' is neither"});
    checkParts(messageOf([] { scene::loadMaterial("wod"); }),
               {"material 'wod' is neither a preset nor a file", "wood-thesis"});
}
