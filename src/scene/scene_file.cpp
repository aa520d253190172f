#include <limits>

#include "core/substeps.hpp"
#include "core/wording.hpp"
#include "files/utf8_path.hpp"
#include "scene/body_reader.hpp"
#include "scene/event_reader.hpp"
#include "scene/limits.hpp"
#include "scene/material_file.hpp"
#include "scene/object_reader.hpp"
#include "scene/presets.hpp"
#include "scene/scene.hpp"
#include "scene/scene_rules.hpp"
#include "scene/table_reader.hpp"
#include "scene/toml_file.hpp"

namespace sunder::scene {

using namespace core;

namespace {

void readSolver(const TableReader& root, Scene& scene) {
    const auto solver = root.table("solver", {"substeps", "max_substeps", "fracture_interval"});
    if (!solver) return;
    scene.autoSubsteps = solver->holds("substeps", kAuto);
    if (!scene.autoSubsteps) solver->read(kSubstepsRule, scene);
    if (solver->read(kMaxSubstepsRule, scene) && !scene.autoSubsteps)
        solver->fail("max_substeps",
                     "max_substeps says nothing where substeps is a number; leave it out, or "
                     "set substeps = " +
                         inQuotes(kAuto));
    solver->read(solverRules(), scene.world);
}

void readGround(const TableReader& root, WorldDescription& world) {
    if (const auto ground = root.table("ground", {"enabled", "friction"})) {
        ground->read("enabled", world.ground);
        ground->read(groundRules(), world);
    }
}

void readRoom(const TableReader& root, WorldDescription& world) {
    const auto table = root.table("room", {"x", "z", "friction", "ceiling"});
    if (!table) return;
    RoomDescription& room = world.room.emplace();
    room.friction = world.groundFriction;
    for (const Rule<RoomDescription>& rule : roomRules()) {
        if (rule.count() == 2) table->require(rule.key, "[low, high] in m, where the walls stand");
        table->read(rule, room);
    }
}

void readContact(const TableReader& root, WorldDescription& world) {
    world.contact = true;
    const auto contact = root.table("contact", {"enabled", "parting_speed"});
    if (!contact) return;
    contact->read("enabled", world.contact);
    contact->read(contactRules(), world);
    if (!world.contact && !world.objects.empty())
        contact->fail("enabled",
                      "the scene has objects, which touch nothing without contact; leave enabled "
                      "out, or remove the objects");
}

void readCamera(const TableReader& root, Scene& scene) {
    const auto table = root.table("camera", {"position", "target", "field_of_view"});
    if (!table) return;
    scene.ownCamera = true;
    CameraDescription& camera = scene.camera;
    table->read(cameraRules(), camera);
    if ((camera.position - camera.target).norm() < 1e-3)
        table->fail("position",
                    "position and target must be at least 0.001 m apart, or it looks nowhere");
}

}  // namespace

Scene parseScene(std::string_view text, const std::string& file,
                 const std::filesystem::path& folder) {
    const toml::table document = parseToml(text, file);
    const TableReader root(document, file, "the scene",
                           {"title", "frames", "gravity", "seed", "solver", "ground", "room",
                            "contact", "camera", "material", "body", "object", "event"});
    Scene scene;
    scene.name = files::utf8FromPath(files::pathFromUtf8(file).stem());
    scene.title = scene.name;
    WorldDescription& world = scene.world;
    root.read("title", scene.title, kMaxTitle);
    root.read(kFramesRule, scene);
    root.read(*findRule(worldRules(), "gravity"), world);
    std::int64_t seed = 1;
    root.read("seed", seed, {0, std::numeric_limits<std::int64_t>::max()});
    world.seed = static_cast<std::uint64_t>(seed);
    readSolver(root, scene);
    readGround(root, world);
    readObjects(root, world);
    readRoom(root, world);
    readContact(root, world);
    readCamera(root, scene);

    MaterialLibrary library(folder);
    library.addOwn(root);
    BodyReader bodies(world, library);
    bodies.readAll(root);
    readEvents(root, bodies, world);
    chooseSubsteps(scene);
    return scene;
}

void chooseSubsteps(Scene& scene) {
    if (scene.autoSubsteps) scene.substeps = substepsFor(scene.world, scene.maxSubsteps);
    scene.world.step = 1.0 / (60.0 * scene.substeps);
}

Scene loadScene(const std::string& nameOrPath) {
    if (const EmbeddedFile* preset = findPreset(PresetKind::Scene, nameOrPath))
        return parseScene(preset->text, nameOrPath + ".toml", {});
    if (!looksLikePath(nameOrPath)) {
        const std::vector<std::string> presets = presetNames(PresetKind::Scene);
        throw InputError("scene " + inQuotes(nameOrPath) +
                         " is neither a preset nor a file; presets: " + joined(presets) +
                         "; a file's path has a '/' or ends in .toml" +
                         suggestion(nameOrPath, presets));
    }
    const std::filesystem::path path = files::pathFromUtf8(nameOrPath);
    return parseScene(readTextFile(path), nameOrPath, path.parent_path());
}

}  // namespace sunder::scene
