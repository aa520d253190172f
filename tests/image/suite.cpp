#include "image/suite.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <set>

#include "files/utf8_path.hpp"
#include "gpu/gather.hpp"
#include "gpu/scatter.hpp"
#include "gpu/test_context.hpp"
#include "image/stored_state.hpp"
#include "render/legend.hpp"
#include "scene/table_reader.hpp"
#include "scene/toml_file.hpp"

using namespace sunder;
using namespace sunder::core;
namespace fs = std::filesystem;

namespace {

constexpr SuiteSolver kSolvers[] = {SuiteSolver::Cpu, SuiteSolver::Gather, SuiteSolver::Scatter};

constexpr Range kThreshold{0, 255}, kShare{0, 1}, kLevels{0, 255}, kPlace{-100, 100, "m"};

/// What rules are about: a number, or three.
template <class T>
struct Single {
    T value{};
};

bool readValue(const scene::TableReader& table, const char* key, std::string& value,
               std::size_t maxCharacters) {
    return table.read(key, value, maxCharacters);
}

template <class T>
bool readValue(const scene::TableReader& table, const char* key, T& value, const Range& range) {
    Single<T> read;
    if (!table.read(Rule<Single<T>>{key, range, &Single<T>::value, ""}, read)) return false;
    value = read.value;
    return true;
}

template <class T, class Allowed>
T required(const scene::TableReader& table, const char* key, const char* hint,
           const Allowed& allowed) {
    table.require(key, hint);
    T value{};
    readValue(table, key, value, allowed);
    return value;
}

image::ComparisonLimits readLimits(const scene::TableReader& table) {
    return {.threshold = required<int>(table, "threshold", "levels, 0 to 255", kThreshold),
            .share = required<double>(table, "share", "0 to 1", kShare),
            .window = required<double>(table, "window", "0 to 1", kShare),
            .mean = required<double>(table, "mean", "levels, 0 to 255", kLevels)};
}

template <class T, class Allowed>
void readOptional(const scene::TableReader& table, const char* key, std::optional<T>& value,
                  const Allowed& allowed) {
    T read{};
    if (readValue(table, key, read, allowed)) value = read;
}

/// Reads one of `choices` by its name; left as it is where the table does not say.
template <class Choice, std::size_t Count>
void readChoice(const scene::TableReader& table, const char* key, Choice& value,
                const Choice (&choices)[Count]) {
    std::array<std::string_view, Count> names;
    std::transform(choices, choices + Count, names.begin(),
                   [](Choice choice) { return toString(choice); });
    if (const auto chosen = table.readChoice(key, names)) value = choices[*chosen];
}

SuitePicture readPicture(const scene::TableReader& table) {
    SuitePicture picture;
    picture.name = required<std::string>(table, "name", "of the baseline", 60);
    // It becomes a file's name, and an argument of tools/update-baselines.
    if (picture.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") !=
        std::string::npos)
        table.fail("name", "name must be of a to z, 0 to 9 and '-'");
    picture.scene = required<std::string>(table, "scene", "a preset", 60);
    picture.frame = required<int>(table, "frame", "of 1/60 s", Range{0, 10000});
    picture.baseline = picture.name;
    table.read("baseline", picture.baseline, 60);
    picture.settings.width = 480;
    picture.settings.height = 270;
    readChoice(table, "solver", picture.solver, kSolvers);
    readChoice(table, "mesh", picture.settings.mesh, render::kDrawnMeshes);
    readChoice(table, "style", picture.settings.style, render::kDrawStyles);
    readChoice(table, "colour", picture.colour, render::kWallColours);
    readOptional(table, "camera", picture.camera, kPlace);
    readOptional(table, "target", picture.target, kPlace);
    readOptional(table, "threshold", picture.threshold, kThreshold);
    readOptional(table, "share", picture.share, kShare);
    readOptional(table, "window", picture.window, kShare);
    readOptional(table, "mean", picture.mean, kLevels);
    return picture;
}

void readPictures(const scene::TableReader& root, Suite& suite) {
    const scene::TableReader::Keys known{"name",      "scene", "frame",  "solver", "baseline",
                                         "mesh",      "style", "colour", "camera", "target",
                                         "threshold", "share", "window", "mean"};
    std::set<std::string> own;
    for (const scene::TableReader& table : root.tables("picture", known, 1000)) {
        const SuitePicture picture = readPicture(table);
        for (const SuitePicture& other : suite.pictures)
            if (other.name == picture.name) table.fail("name", "another picture has this name");
        if (picture.ownBaseline()) own.insert(picture.name);
        // What is above it, so that no two can name each other.
        else if (!own.count(picture.baseline))
            table.fail("baseline", "no picture above has a baseline '" + picture.baseline + "'");
        suite.pictures.push_back(picture);
    }
}

std::unique_ptr<gpu::GpuSolver> makeGpuSolver(SuiteSolver solver, const World& world,
                                              const gpu::WorldBuffers& buffers) {
    if (solver == SuiteSolver::Gather) return std::make_unique<gpu::GatherSolver>(world, buffers);
    return std::make_unique<gpu::ScatterSolver>(world, buffers);
}

}  // namespace

std::string_view toString(SuiteSolver solver) {
    switch (solver) {
        case SuiteSolver::Gather:
            return "gather";
        case SuiteSolver::Scatter:
            return "scatter";
        case SuiteSolver::Cpu:
            break;
    }
    return "cpu";
}

const SuitePicture& Suite::picture(const std::string& name) const {
    for (const SuitePicture& picture : pictures)
        if (picture.name == name) return picture;
    throw InputError("the suite has no picture '" + name + "'");
}

bool Suite::madeBaselines(const gl::DeviceInfo& device) const {
    return device.renderer.starts_with(baselineRenderer) &&
           device.version.find(baselineVersion) != std::string::npos;
}

image::ComparisonLimits Suite::limits(const SuitePicture& picture,
                                      const gl::DeviceInfo& device) const {
    const bool made = madeBaselines(device);
    image::ComparisonLimits limits = made ? baselineLimits : otherLimits;
    const auto adapt = [made](auto& limit, const auto& own) {
        if (own) limit = made ? *own : std::max(limit, *own);
    };
    adapt(limits.threshold, picture.threshold);
    adapt(limits.share, picture.share);
    adapt(limits.window, picture.window);
    adapt(limits.mean, picture.mean);
    return limits;
}

Suite parseSuite(std::string_view text, const std::string& file) {
    const toml::table table = scene::parseToml(text, file);
    const scene::TableReader root(table, file, "the suite",
                                  {"baseline_driver", "other_drivers", "picture"});
    Suite suite;
    root.require("baseline_driver", "a table");
    root.require("other_drivers", "a table");
    const scene::TableReader baseline = *root.table(
        "baseline_driver", {"renderer", "version", "threshold", "share", "window", "mean"});
    suite.baselineRenderer =
        required<std::string>(baseline, "renderer", "how GL_RENDERER begins", 100);
    suite.baselineVersion =
        required<std::string>(baseline, "version", "what GL_VERSION contains", 100);
    suite.baselineLimits = readLimits(baseline);
    suite.otherLimits =
        readLimits(*root.table("other_drivers", {"threshold", "share", "window", "mean"}));
    readPictures(root, suite);
    return suite;
}

Suite readSuite(const fs::path& path) {
    return parseSuite(scene::readTextFile(path),
                      "tests/image/" + files::utf8FromPath(path.filename()));
}

fs::path baselineOf(const fs::path& folder, const SuitePicture& picture) {
    return folder / "baselines" / (picture.baseline + ".png");
}

fs::path stateOf(const fs::path& folder, const SuitePicture& picture) {
    return folder / "states" / (picture.scene + "-" + std::to_string(picture.frame) + ".state");
}

image::Image drawSuitePicture(const SuitePicture& picture, const fs::path& folder,
                              const SceneChange& change) {
    testContext();
    scene::Scene scene = scene::loadScene(picture.scene);
    scene.camera.position = picture.camera.value_or(scene.camera.position);
    scene.camera.target = picture.target.value_or(scene.camera.target);
    change(scene);
    const World world(scene.world);
    const gpu::WorldBuffers buffers(world);
    render::Renderer renderer(world, buffers);
    render::CellColours colours(world);
    render::RenderSettings settings = picture.settings;
    settings.colours = &colours;
    const auto draw = [&](const gpu::StateView& view, const State& state) {
        colours.update(state, picture.colour);
        image::Image image = renderer.draw(view, scene.camera, settings);
        render::drawLegend(image, colours.key());
        return image;
    };
    if (picture.solver != SuiteSolver::Cpu) {
        const auto solver = makeGpuSolver(picture.solver, world, buffers);
        solver->advance(scene.substeps * picture.frame);
        solver->finish();
        return draw(solver->view(), solver->state());
    }
    const State state =
        picture.storedState() ? readState(stateOf(folder, picture), world) : world.initialState();
    gpu::StateUpload upload(world);
    return draw(upload.upload(state), state);
}
