#include "image/suite.hpp"

#include <toml++/toml.h>
#include <algorithm>

#include "cpu/cpu_solver.hpp"
#include "gpu/test_context.hpp"
#include "render/legend.hpp"

using namespace sunder;

namespace {

[[noreturn]] void fail(const toml::node& where, const std::string& problem) {
    throw InputError("tests/image/suite.toml:" + std::to_string(where.source().begin.line) + ": " +
                     problem);
}

template <class T>
T required(const toml::table& table, const char* key) {
    if (const auto value = table[key].value<T>()) return *value;
    fail(table, std::string(key) + " is missing, or of another type");
}

ComparisonLimits readLimits(const toml::table& table) {
    return {.threshold = static_cast<int>(required<std::int64_t>(table, "threshold")),
            .share = required<double>(table, "share"),
            .window = required<double>(table, "window"),
            .mean = required<double>(table, "mean")};
}

/// Reads one of `choices` by its name; left as it is where the table does not say.
template <class Choice, std::size_t Count>
void readChoice(const toml::table& table, const char* key, Choice& value,
                const Choice (&choices)[Count]) {
    const auto word = table[key].value<std::string>();
    if (!word) return;
    const auto found = std::find_if(choices, choices + Count,
                                    [&](Choice choice) { return toString(choice) == *word; });
    if (found == choices + Count) fail(table, std::string(key) + " cannot be '" + *word + "'");
    value = *found;
}

SuitePicture readPicture(const toml::table& table) {
    const std::vector<std::string> known{"name", "scene", "frame", "mesh", "style", "colour"};
    for (const auto& [key, value] : table)
        if (std::find(known.begin(), known.end(), key.str()) == known.end())
            fail(value, "unknown key '" + std::string(key.str()) + "'");
    SuitePicture picture;
    picture.name = required<std::string>(table, "name");
    picture.scene = required<std::string>(table, "scene");
    picture.frame = static_cast<int>(required<std::int64_t>(table, "frame"));
    picture.settings.width = 480;
    picture.settings.height = 270;
    readChoice(table, "mesh", picture.settings.mesh, kDrawnMeshes);
    readChoice(table, "style", picture.settings.style, kDrawStyles);
    readChoice(table, "colour", picture.colour, kWallColours);
    return picture;
}

}  // namespace

Suite readSuite(const std::filesystem::path& path) {
    const toml::table file = toml::parse_file(path.string());
    Suite suite;
    const toml::table& baseline = *file["baseline_driver"].as_table();
    suite.baselineRenderer = required<std::string>(baseline, "renderer");
    suite.baselineLimits = readLimits(baseline);
    suite.otherLimits = readLimits(*file["other_drivers"].as_table());
    for (const toml::node& picture : *file["picture"].as_array())
        suite.pictures.push_back(readPicture(*picture.as_table()));
    return suite;
}

Image drawSuitePicture(const SuitePicture& picture, const std::function<void(Scene&)>& change) {
    testContext();
    Scene scene = loadScene(picture.scene);
    change(scene);
    const World world(scene.world);
    CpuSolver solver(world, 0);
    solver.advance(scene.substeps * picture.frame);
    const State state = solver.state();

    CellColours colours(world);
    colours.update(state, picture.colour);
    const gpu::WorldBuffers buffers(world);
    gpu::StateUpload upload(world);
    Renderer renderer(world, buffers);
    RenderSettings settings = picture.settings;
    settings.colours = &colours;
    Image image = renderer.draw(upload.upload(state), scene.camera, settings);
    drawLegend(image, colours.key());
    return image;
}
