#include "view/controls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::view {
namespace {

using gl::Input;
using gl::Key;

constexpr double kShotsApart = 0.12;  // s, while the mouse is dragged

template <class Value, std::size_t Count>
void next(Session& session, const char* name, Value& value, const Value (&values)[Count]) {
    const auto at = std::find(values, values + Count, value) - values;
    value = values[(at + 1) % static_cast<std::ptrdiff_t>(Count)];
    session.changed(name, toString(value));
}

void nextSolver(Session& session) {
    const auto& known = solvers();
    const std::string& now = session.stage->simulation.solverInfo().name;
    const auto at = std::find_if(known.begin(), known.end(),
                                 [&](const SolverInfo& solver) { return solver.name == now; });
    session.setSolver(known[(at - known.begin() + 1) % known.size()].name);
}

/// True: quit.
bool pressKey(Session& session, Key key, const gl::Modifiers& with) {
    Settings& settings = session.settings;
    if (with.control) return key == gl::key('Q');
    if (key >= gl::key('1') && key <= gl::key('9')) {
        session.hitPreset(static_cast<int>(key) - '0');
        return false;
    }
    switch (static_cast<int>(key)) {
        case ' ':
            session.setPaused(!session.clock.paused());
            break;
        case '.':
            session.stepOnce(session.stage->simulation.stepsPerFrame());
            break;
        case ',':
            session.stepOnce(1);
            break;
        case '[':
            session.setSpeed(session.clock.speed() / 2);
            break;
        case ']':
            session.setSpeed(session.clock.speed() * 2);
            break;
        case 'R':
            session.restart();
            break;
        case 'N':
            session.newSeed();
            break;
        case 'T':
            next(session, "tool", settings.tool, kTools);
            break;
        case 'M':
            next(session, "mesh", settings.mesh, kDrawnMeshes);
            break;
        case 'L':
            next(session, "style", settings.style, kDrawStyles);
            break;
        case 'C':
            next(session, "colour", settings.colour, kWallColours);
            break;
        case 'G':
            nextSolver(session);
            break;
        case 'P':
        case static_cast<int>(Key::F12):
            session.takePicture();
            break;
        case 'V':
            session.toggleRecording();
            break;
        case 'H':
        case static_cast<int>(Key::F1):
            session.help = !session.help;
            break;
        case static_cast<int>(Key::Home):
            session.camera.reset();
            break;
        case static_cast<int>(Key::F11):
            session.setFullScreen(!session.window.fullScreen());
            break;
        case static_cast<int>(Key::Tab):
            settings.panel = !settings.panel;
            session.changed("panel", settings.panel ? "true" : "false");
            break;
        case static_cast<int>(Key::Escape):
            if (session.help)
                session.help = false;
            else if (session.lookedAt)
                session.lookedAt.reset();
            else if (session.window.fullScreen())
                session.setFullScreen(false);
            break;
        default:
            break;
    }
    return false;
}

/// Camera by held keys.
void fly(OrbitCamera& camera, const Input& input, double elapsed) {
    const auto axis = [&](Key back, Key ahead) {
        return static_cast<double>(input.held.count(ahead)) -
               static_cast<double>(input.held.count(back));
    };
    const double step = std::min(elapsed, 0.1) * camera.distance() * 0.8;
    camera.move(step * axis(gl::key('S'), gl::key('W')), step * axis(gl::key('A'), gl::key('D')),
                step * axis(gl::key('Q'), gl::key('E')));
    const double turn = 1.5 * std::min(elapsed, 0.1);
    camera.orbit(turn * axis(Key::Left, Key::Right), turn * axis(Key::Down, Key::Up));
}

void turnWheel(Session& session, const Input& input) {
    Settings& settings = session.settings;
    const double factor = std::pow(1.1, input.wheel);
    if (input.wheelWith.control) {
        settings.radius = std::clamp(settings.radius * factor, 0.02, 2.0);
        session.log.add("radius", {{"value", settings.radius}});
    } else if (input.wheelWith.shift) {
        const bool shot = settings.tool == Tool::Shoot;
        double& strength = shot ? settings.shot : settings.push;
        strength = std::clamp(strength * factor, 1.0, shot ? 150.0 : 2000.0);
        session.log.add("strength", {{"value", strength}});
    } else {
        session.camera.zoom(factor);
    }
}

}  // namespace

bool Controls::handle(Session& session, const Interface& ui, double elapsed) {
    sinceShot_ += elapsed;
    for (const std::string& path : session.window.input().dropped) session.openScene(path);
    handleMouse(session, ui);
    return handleKeys(session, ui, elapsed);
}

bool Controls::handleKeys(Session& session, const Interface& ui, double elapsed) {
    if (ui.wantsKeyboard()) return true;
    const Input& input = session.window.input();
    for (const Input::KeyPress& pressed : input.keys)
        if (pressKey(session, pressed.key, pressed.with)) return false;
    fly(session.camera, input, elapsed);
    return true;
}

void Controls::handleMouse(Session& session, const Interface& ui) {
    const Input& input = session.window.input();
    // While a button is held, the pointer may go anywhere.
    const bool over = (input.inside || input.anyButton()) &&
                      session.area.contains(input.x, input.y) && !ui.wantsMouse();

    // A press, its way and its release may come in one frame: what it started is done all the same.
    if (std::exchange(released_, !input.anyButton())) drag_ = Drag::None;
    for (const Input::Click& click : input.clicks)
        if (session.area.contains(click.x, click.y) && !ui.wantsMouse()) press(session, click);

    // Where the mouse points. That costs a GPU solver's state and a look at every cell: seldom
    // while no button is pressed, and more so while the mouse rests.
    const bool moved = input.moveX != 0 || input.moveY != 0;
    if (!over)
        session.hovered.reset();
    else if (drag_ == Drag::Hit)
        lookAt(session, input.x, input.y);
    else if (drag_ == Drag::None && (moved || ++sinceLook_ > 15))
        hovering_.now([&] { lookAt(session, input.x, input.y); });

    if (over && input.wheel != 0) turnWheel(session, input);
    if (drag_ == Drag::Orbit)
        session.camera.orbit(-5 * input.moveX / session.area.height,
                             5 * input.moveY / session.area.height);
    if (drag_ == Drag::Pan)
        session.camera.pan(input.moveX / session.area.height, -input.moveY / session.area.height);
    if (drag_ == Drag::Hit && session.settings.tool == Tool::Shoot && moved &&
        sinceShot_ > kShotsApart)
        hit(session, input.x, input.y);
}

void Controls::press(Session& session, const Input::Click& click) {
    if (click.button != gl::MouseButton::Left) {
        const bool pan = click.button == gl::MouseButton::Middle || click.with.shift;
        drag_ = pan ? Drag::Pan : Drag::Orbit;
        return;
    }
    lookAt(session, click.x, click.y);
    drag_ = session.hovered ? Drag::Hit : Drag::Orbit;
    if (!session.hovered) return;
    if (click.with.alt || click.with.control) {
        session.look(*session.hovered);
        drag_ = Drag::None;
    } else if (session.settings.tool == Tool::Look) {
        session.look(*session.hovered);
    } else if (session.settings.tool == Tool::Shoot) {
        hit(session, click.x, click.y);
    }
}

void Controls::lookAt(Session& session, double x, double y) {
    sinceLook_ = 0;
    session.hovered =
        session.stage->pick(session.camera.description().position, session.rayAt(x, y));
}

void Controls::hit(Session& session, double x, double y) {
    if (!session.hovered) return;
    sinceShot_ = 0;
    session.hit(*session.hovered, session.rayAt(x, y), 0);
}

void Controls::holdHits(Session& session, double seconds) {
    const Tool tool = session.settings.tool;
    if (drag_ != Drag::Hit || !session.hovered || seconds <= 0) return;
    if (tool != Tool::Push && tool != Tool::Pull) return;
    const Input& input = session.window.input();
    session.hit(*session.hovered, session.rayAt(input.x, input.y), seconds);
}

}  // namespace sunder::view
