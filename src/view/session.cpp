#include "view/session.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

#include "files/utf8_path.hpp"
#include "files/write_file.hpp"
#include "image/image.hpp"
#include "render/legend.hpp"
#include "scene/scene_writer.hpp"
#include "sim_gl/solvers.hpp"
#include "view/every.hpp"
#include "view/framing.hpp"

namespace sunder::view {

using namespace core;

namespace {

namespace fs = std::filesystem;
/// NAME.toml in the folder, or NAME where it is a path already. Throws InputError.
fs::path tomlPath(const fs::path& folder, const std::string& name) {
    if (name.empty()) throw InputError("give a name to save it under");
    fs::path path = files::pathFromUtf8(name);
    if (path.extension() != ".toml") path += ".toml";
    return path.is_absolute() ? path : folder / path;
}

}  // namespace

Session::Session(window::Window& shown, const Options& options, Settings remembered)
    : window(shown),
      settings(std::move(remembered)),
      log(options.log),
      clock(1.0 / 3000),
      camera(scene::CameraDescription{}),
      folder(options.folder),
      opened_(scene::loadScene(options.scene)) {
    if (!options.solver.empty()) settings.solver = sim_gl::findSolver(options.solver).name;
    const auto start = Instant::now();
    stage = newStage(opened_, nullptr, nullptr);
    buildTime_ = secondsSince(start);
    sayCompromises();
    if (!options.shaders.empty()) {
        shaders_.emplace(options.shaders);
        tryShaders();
    }
    clock.setStep(stage->simulation.world().step());
    lookHome();
    log.add("started", {{"gl_renderer", window.info().renderer},
                        {"gl_version", window.info().version},
                        {"scene", opened_.name},
                        {"build_seconds", buildTime_}});
}

template <class Action>
bool Session::attempt(Action&& action) {
    try {
        action();
        return true;
    } catch (const DeviceError&) {
        throw;
    } catch (const std::bad_alloc&) {
        say("There is not enough memory for that; use fewer cells", true);
    } catch (const std::runtime_error& error) {
        say(error.what(), true);
    }
    return false;
}

std::unique_ptr<Stage> Session::newStage(scene::Scene scene, const State* state,
                                         const Stage* like) {
    auto next =
        std::make_unique<Stage>(std::move(scene), settings.solver, settings.sceneHits, state, like);
    // Where nothing has happened yet, what is changed was so from the start.
    if (state && stage->simulation.atStart()) next->simulation.restart();
    next->rehearse(settings.mesh, settings.style);
    return next;
}

bool Session::rebuild(scene::Scene scene, const State* state) {
    const auto start = Instant::now();
    const bool built = attempt([&] {
        auto next = newStage(std::move(scene), state, stage.get());
        if (state) next->colours.continueScales(stage->colours);
        stage = std::move(next);
    });
    clock.skip();
    if (!built) return false;
    ++generation_;
    buildTime_ = secondsSince(start);
    if (!state) {
        ++layout_;
        lookedAt.reset();
        measurements.breaks = measurements.contacts = 0;
        sayCompromises();
    }
    hovered.reset();
    pushes_.clear();
    measurements.passes.clear();
    clock.setStep(stage->simulation.world().step());
    return true;
}

void Session::sayCompromises() {
    if (stage->renderer.displayMesh().simplified())
        say("Torn edges have fewer points than the materials ask for: there would be too many");
    if (std::string warning = stage->simulation.startWarning(); !warning.empty()) {
        warning[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(warning[0])));
        say(warning, true);
    }
}

void Session::openScene(const std::string& nameOrPath) {
    scene::Scene scene;
    if (!attempt([&] { scene = scene::loadScene(nameOrPath); })) return;
    const scene::Scene previous = std::exchange(opened_, scene);
    if (!rebuild(std::move(scene), nullptr)) {
        opened_ = previous;
        return;
    }
    lookHome();
    log.add("scene", {{"value", opened_.name}});
}

void Session::buildScene(scene::Scene scene, const char* why) {
    if (rebuild(std::move(scene), nullptr)) log.add(why);
}

void Session::setMaterial(int index, const Material& material) {
    scene::Scene changedScene = scene();
    const std::string name = material.name;
    changedScene.world.materials[index] = material;
    scene::chooseSubsteps(changedScene);
    State state = stage->simulation.state();
    // The same time, whatever a substep takes now.
    state.step =
        std::llround(static_cast<double>(state.step) * changedScene.substeps / scene().substeps);
    if (rebuild(std::move(changedScene), &state))
        log.add("material", {{"index", index}, {"value", name}});
}

void Session::newSeed() {
    scene::Scene next = scene();
    // 63 bits: what a scene file may hold.
    next.world.seed = (next.world.seed + 1) & std::numeric_limits<std::int64_t>::max();
    const std::uint64_t seed = next.world.seed;
    if (!rebuild(std::move(next), nullptr)) return;
    log.add("seed", {{"value", seed}});
    say("A new wall, seed " + std::to_string(seed));
}

bool Session::save(const fs::path& path, std::string_view bytes) {
    if (ownFiles_.count(path)) {
        files::writeFile(path, bytes);
        return true;
    }
    const bool written = files::writeNewFile(path, bytes);
    ownFiles_.insert(path);
    if (written) return true;
    say(files::utf8FromPath(path) + " is there already; save again to replace it", true);
    return false;
}

fs::path Session::unnumbered(const char* ending) const {
    return folder / (scene().name + ending);
}

void Session::saveScene(const std::string& name) {
    attempt([&] {
        const fs::path path = tomlPath(folder, name);
        scene::Scene saved = scene();
        saved.camera = camera.description();
        if (!save(path, scene::writeScene(saved))) return;
        say("Saved; run it with: sunder run " + files::utf8FromPath(path));
        log.add("saved_scene", {{"path", files::utf8FromPath(path)}});
    });
}

void Session::saveMaterial(int index, const std::string& name) {
    attempt([&] {
        const fs::path path = tomlPath(folder, name);
        if (!save(path, scene::writeMaterial(scene().world.materials[index]))) return;
        say("Saved; a scene uses it by: material = \"" + files::utf8FromPath(path.filename()) +
            "\"");
        log.add("saved_material", {{"path", files::utf8FromPath(path)}});
    });
}

void Session::restart() {
    stage->simulation.restart();
    pushes_.clear();
    measurements.breaks = measurements.contacts = 0;
    log.add("restart");
}

void Session::setSceneHits(bool wanted) {
    const bool before = std::exchange(settings.sceneHits, wanted);
    if (!rebuild(scene(), nullptr)) {
        settings.sceneHits = before;
        return;
    }
    log.add(wanted ? "scene_hits_on" : "scene_hits_off");
}

void Session::setPaused(bool paused) {
    clock.pause(paused);
    log.add("pause", {{"value", paused}});
}

void Session::stepOnce(int steps) {
    clock.pause(true);
    clock.stepOnce(steps);
    log.add("step", {{"steps", steps}});
}

void Session::setSpeed(double speed) {
    clock.setSpeed(speed);
    log.add("speed", {{"value", clock.speed()}});
}

void Session::setSolver(const std::string& name) {
    if (name == stage->simulation.solverInfo().name) return;
    const bool set = attempt([&] { stage->simulation.setSolver(name); });
    clock.skip();
    if (!set) return;
    settings.solver = name;
    measurements.passes.clear();
    clock.setStep(clock.step());  // what a step costs is no longer known
    changed("solver", name);
}

void Session::changed(const char* what, std::string_view value) {
    log.add(what, {{"value", value}});
}

void Session::setFullScreen(bool wanted) {
    settings.fullScreen = wanted;
    window.setFullScreen(wanted);
    changed("full_screen", wanted ? "true" : "false");
}

void Session::setVsync(bool wanted) {
    settings.vsync = wanted;
    window.setVsync(wanted);
    changed("vsync", wanted ? "true" : "false");
}

void Session::setSamples(int samples) {
    settings.samples = samples;
    log.add("samples", {{"value", samples}});
}

bool Session::composed() const {
    const auto& then = opened_.world.bodies;
    const auto& now = scene().world.bodies;
    const auto alike = [](const BodyDescription& a, const BodyDescription& b) {
        return a.size == b.size && a.position == b.position &&
               a.orientation.coeffs() == b.orientation.coeffs();
    };
    return opened_.ownCamera && std::equal(then.begin(), then.end(), now.begin(), now.end(), alike);
}

void Session::lookHome() {
    const World& world = stage->simulation.world();
    camera.setHome(framed(opened_.camera, world, area.aspect(), composed()),
                   groundClearance(world, opened_.camera));
}

void Session::keepHome() {
    const std::array<int, 3> now{area.width, area.height, layout_};
    if (std::exchange(homeFor_, now) == now) return;
    if (camera.moved())
        camera.setClearance(groundClearance(stage->simulation.world(), opened_.camera));
    else
        lookHome();
}

Vec3 Session::rayAt(double x, double y) const {
    return camera.ray(2 * (x - area.left) / area.width - 1, 1 - 2 * (y - area.top) / area.height,
                      area.aspect());
}

void Session::hit(const surface::Spot& spot, const Vec3& direction, double seconds) {
    if (settings.tool == Tool::Look) return look(spot);
    const double change = settings.tool == Tool::Shoot ? settings.shot : settings.push * seconds;
    const double sign = settings.tool == Tool::Pull ? -1 : 1;
    pushes_.push_back({spot.place, sign * change * direction, settings.radius, spot.object});
    if (settings.tool == Tool::Shoot || !everHit)
        log.add("hit", {{"tool", toString(settings.tool)},
                        {"place", {spot.place[0], spot.place[1], spot.place[2]}},
                        {"cell", spot.cell},
                        {"object", spot.object}});
    everHit = true;
}

void Session::look(const surface::Spot& spot) {
    if (spot.cell < 0) return;
    lookedAt = spot.cell;
    log.add("look", {{"cell", spot.cell}});
}

void Session::hitPreset(int number) {
    const World& world = stage->simulation.world();
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::max()), high = -low;
    for (const Body& body : world.bodies()) {
        const Box box = body.bounds();
        low = low.cwiseMin(box.low);
        high = high.cwiseMax(box.high);
    }
    const Vec3 share((number - 1) % 3 / 3.0 + 1.0 / 6, (number - 1) / 3 / 3.0 + 1.0 / 6, 0.5);
    const Vec3 place = low + share.cwiseProduct(high - low);
    const Vec3 eye = camera.description().position;
    const Vec3 direction = (place - eye).normalized();
    // Where nothing is left at that place, whatever is around it is hit all the same.
    const surface::Spot spot = stage->pick(eye, direction).value_or(surface::Spot{.place = place});
    log.add("preset", {{"number", number}});
    constexpr double kTap = 0.05;  // s that a tap on a key counts for
    hit(spot, direction, kTap);
}

void Session::addLegend(image::Image& picture) const {
    if (settings.colour != render::WallColour::Material)
        render::drawLegend(picture, stage->colours.key());
}

void Session::savePicture(image::Image picture) {
    pictureWanted_ = false;
    attempt([&] {
        addLegend(picture);
        const fs::path path =
            files::writeNumberedFile(unnumbered(".png"), image::encodePng(picture));
        say("Picture saved: " + files::utf8FromPath(path));
        log.add("picture", {{"path", files::utf8FromPath(path)}});
    });
}

void Session::toggleRecording() {
    if (recorder_) {
        endRecording();
        return;
    }
    attempt([&] {
        recorder_.emplace(unnumbered(".mp4"), area.width, area.height);
        clock.setFixed(true);
        log.add("recording", {{"folder", files::utf8FromPath(folder)}});
    });
}

std::string Session::endRecording() {
    std::string outcome;
    const bool well = attempt([&] { outcome = finishRecording(); });
    dropRecorder();
    if (well) say(outcome);
    return messages_.back().text;
}

void Session::dropRecorder() {
    clock.setFixed(false);
    recorder_.reset();
}

std::string Session::finishRecording() {
    const int frames = recorder_->frames();
    const std::string path = frames > 0 ? files::utf8FromPath(recorder_->finish()) : "";
    log.add("video", {{"path", path}, {"frames", frames}});
    if (frames == 0) return "No picture was recorded, so there is no video";
    return path.empty() ? "The video was given up" : "Video saved: " + path;
}

void Session::record(image::Image picture) {
    try {
        addLegend(picture);
        if (recorder_->add(picture)) return;
        say("The window has another size now; the video ends before");
        endRecording();
    } catch (const InputError& error) {
        dropRecorder();
        say(error.what(), true);
    }
}

void Session::tryShaders() {
    const gl::ShaderSource source = shaders_->source();
    gl::useShaders(source);
    const State state = stage->simulation.state();
    clock.skip();
    try {
        auto next = newStage(scene(), &state, nullptr);  // textures are made by shaders, too
        for (const render::DrawnMesh mesh : render::kDrawnMeshes)
            for (const render::DrawStyle style : render::kDrawStyles) next->rehearse(mesh, style);
        next->colours.continueScales(stage->colours);
        stage = std::move(next);
        soundShaders_ = source;
        ++generation_;
        shaderError_.clear();
        log.add("shaders", {{"error", nullptr}});
    } catch (const DeviceError&) {
        throw;
    } catch (const std::runtime_error& error) {
        // The programs that run go on, and what is made meanwhile is made of sound ones.
        gl::useShaders(soundShaders_);
        shaderError_ = error.what();
        log.add("shaders", {{"error", shaderError_}});
    }
}

void Session::watchShaders() {
    if (!shaders_ || !shaders_->changed()) return;
    tryShaders();
    if (shaderError_.empty()) say("Shaders reloaded");
}

void Session::say(const std::string& text, bool problem) {
    constexpr std::chrono::seconds kShort(4), kLong(10);
    messages_.push_back({text, problem, Instant::now() + (problem ? kLong : kShort)});
    if (messages_.size() > 5) messages_.pop_front();
    log.add(problem ? "problem" : "message", {{"text", text}});
}

void Session::forgetOldMessages() {
    const auto now = Instant::now();
    std::erase_if(messages_, [&](const Message& message) { return message.until < now; });
}

}  // namespace sunder::view
