#include "view/controls.hpp"
#include "sim_gl/solvers.hpp"

#include <algorithm>
#include <cmath>

namespace sunder::view {
namespace {

using window::Input;
using window::InputEvent;
using window::Key;

constexpr double kShotsApart = 0.12;  // s, while the mouse is dragged

template <class Value, std::size_t Count>
void next(Session& session, const char* name, Value& value, const Value (&values)[Count]) {
    const auto at = std::find(values, values + Count, value) - values;
    value = values[(at + 1) % static_cast<std::ptrdiff_t>(Count)];
    session.changed(name, toString(value));
}

void nextSolver(Session& session) {
    const auto& known = sim_gl::solvers();
    const std::string& now = session.stage->simulation.solverInfo().name;
    const auto at = std::find_if(known.begin(), known.end(),
                                 [&](const sim::SolverInfo& solver) { return solver.name == now; });
    session.setSolver(known[(at - known.begin() + 1) % known.size()].name);
}

/// True: quit.
bool pressKey(Session& session, Key key, const window::Modifiers& with) {
    Settings& settings = session.settings;
    if (with.control) return key == window::key('Q');
    if (key >= window::key('1') && key <= window::key('9')) {
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
            next(session, "mesh", settings.mesh, render::kDrawnMeshes);
            break;
        case 'L':
            next(session, "style", settings.style, render::kDrawStyles);
            break;
        case 'C':
            next(session, "colour", settings.colour, render::kWallColours);
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
            session.lookHome();
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

const core::Range& settingsRange(std::string_view key) {
    return core::findRule(settingsRules(), key)->range;
}

void turnWheel(Session& session, const InputEvent& turned) {
    Settings& settings = session.settings;
    // macOS turns it to the side with Shift held.
    const double factor = std::pow(1.1, turned.wheelY != 0 ? turned.wheelY : turned.wheelX);
    if (turned.with.control) {
        settings.radius = settingsRange("radius").nearest(settings.radius * factor);
        session.log.add("radius", {{"value", settings.radius}});
    } else if (turned.with.shift) {
        const bool shot = settings.tool == Tool::Shoot;
        double& strength = shot ? settings.shot : settings.push;
        strength = settingsRange(shot ? "shot" : "push").nearest(strength * factor);
        session.log.add("strength", {{"value", strength}});
    } else {
        session.camera.zoom(factor);
    }
}

}  // namespace

void Controls::begin(double elapsed) {
    sinceShot_ += elapsed;
    moved_ = false;
    aim_.reset();
    taps_.clear();
    tapped_.clear();
}

bool Controls::take(Session& session, const Interface& ui, const InputEvent& event) {
    const bool over = session.area.contains(event.x, event.y) && !ui.wantsMouse();
    switch (event.kind) {
        case InputEvent::Kind::Move:
            move(session, event);
            break;
        case InputEvent::Kind::Press:
            if (over) press(session, event);
            break;
        case InputEvent::Kind::Release:
            release(event);
            break;
        case InputEvent::Kind::Wheel:
            if (over) turnWheel(session, event);
            break;
        case InputEvent::Kind::KeyDown:
            if (ui.wantsKeyboard()) break;
            tapped_.insert(event.key);
            return !pressKey(session, event.key, event.with);
        case InputEvent::Kind::Blur:
            drag_ = Drag::None;
            break;
        default:
            break;
    }
    return true;
}

void Controls::move(Session& session, const InputEvent& moved) {
    moved_ = true;
    const double x = moved.moveX / session.area.height, y = moved.moveY / session.area.height;
    if (drag_ == Drag::Orbit) session.camera.orbit(-5 * x, 5 * y);
    if (drag_ == Drag::Pan) session.camera.pan(x, -y);
}

void Controls::press(Session& session, const InputEvent& pressed) {
    button_ = pressed.button;
    if (pressed.button != window::MouseButton::Left) {
        const bool pan = pressed.button == window::MouseButton::Middle || pressed.with.shift;
        drag_ = pan ? Drag::Pan : Drag::Orbit;
        return;
    }
    lookAt(session, pressed.x, pressed.y);
    drag_ = session.hovered ? Drag::Hit : Drag::Orbit;
    if (!session.hovered) return;
    aim_ = {*session.hovered, session.rayAt(pressed.x, pressed.y)};
    if (pressed.with.alt || pressed.with.control) {
        session.look(*session.hovered);
        drag_ = Drag::None;
    } else if (session.settings.tool == Tool::Look) {
        session.look(*session.hovered);
    } else if (session.settings.tool == Tool::Shoot) {
        hit(session, pressed.x, pressed.y);
    }
}

void Controls::release(const InputEvent& released) {
    if (released.button != button_) return;
    if (drag_ == Drag::Hit && aim_) taps_.push_back(*aim_);
    aim_.reset();
    drag_ = Drag::None;
}

void Controls::goOn(Session& session, const Interface& ui, double elapsed) {
    const Input& input = session.window.input();
    // While a button is held, the pointer may go anywhere.
    const bool over = (input.inside || input.anyButton()) &&
                      session.area.contains(input.x, input.y) && !ui.wantsMouse();
    // Where the mouse points. That costs a GPU solver's state and a look at every cell: seldom
    // while no button is pressed, and more so while the mouse rests.
    if (!over)
        session.hovered.reset();
    else if (drag_ == Drag::Hit)
        lookAt(session, input.x, input.y);
    else if (drag_ == Drag::None && (moved_ || ++sinceLook_ > 15))
        hovering_.now([&] { lookAt(session, input.x, input.y); });

    if (drag_ == Drag::Hit && session.settings.tool == Tool::Shoot && moved_ &&
        sinceShot_ > kShotsApart)
        hit(session, input.x, input.y);
    if (!ui.wantsKeyboard()) fly(session, elapsed);
}

/// The camera, by keys. One that was only tapped was held for this frame.
void Controls::fly(Session& session, double elapsed) const {
    OrbitCamera& camera = session.camera;
    const std::set<Key>& held = session.window.input().held;
    const auto down = [&](Key key) { return held.count(key) || tapped_.count(key) ? 1.0 : 0.0; };
    const auto axis = [&](Key back, Key ahead) { return down(ahead) - down(back); };
    const double time = std::min(elapsed, 0.1), step = time * camera.distance() * 0.8;
    camera.move(step * axis(window::key('S'), window::key('W')),
                step * axis(window::key('A'), window::key('D')),
                step * axis(window::key('Q'), window::key('E')));
    const double turn = 1.5 * time;
    camera.orbit(turn * axis(Key::Left, Key::Right), turn * axis(Key::Down, Key::Up));
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
    if (seconds <= 0 || (tool != Tool::Push && tool != Tool::Pull)) return;
    if (drag_ == Drag::Hit && session.hovered) {
        const Input& input = session.window.input();
        session.hit(*session.hovered, session.rayAt(input.x, input.y), seconds);
    }
    // Held for less than a frame: it is not known for how much of it.
    for (const Aim& tap : taps_)
        session.hit(tap.spot, tap.direction, seconds / static_cast<double>(taps_.size()));
}

}  // namespace sunder::view
