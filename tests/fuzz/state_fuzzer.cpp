// Saved states that somebody changed (core/saved_state.hpp): refused in a sentence, and then
// nothing has changed, or gone on from for a few steps.
//
// The input says which of some true states to begin with and how to change it: where, what, and
// whether length and checksum are made right again.
#include <algorithm>
#include <cstring>

#include "core/diagnostics.hpp"
#include "core/incident.hpp"
#include "core/saved_state.hpp"
#include "cpu/cpu_solver.hpp"
#include "cpu/reference.hpp"
#include "fuzz/fuzzer.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t kLengthAt = 32, kHeader = 40, kChecksum = 8;  // saved_state.hpp

/// A wall that breaks, something of several spheres a cell that lies on the ground, a ball, a box.
WorldDescription described() {
    WorldDescription world;
    Material& material = world.materials.emplace_back();
    material.youngModulus = 1e6;
    material.strength = material.boundaryStrength = {2e3, 2e3, 2e3};
    BodyDescription& wall = world.bodies.emplace_back();
    wall.size = {0.3, 0.2, 0.1};
    wall.cells = {3, 2, 1};
    Material& cells = world.materials.emplace_back();
    cells.fracture = FractureMode::Cell;
    cells.youngModulus = 1e11;
    cells.density = 2e4;
    cells.damping = 10;
    BodyDescription& beam = world.bodies.emplace_back();
    beam.size = {0.6, 0.1, 0.1};
    beam.cells = {2, 1, 1};
    beam.position = {0, 0, 0.3};
    beam.material = 1;
    world.contact = true;
    world.step = 1.0 / 600;
    ObjectDescription& ball = world.objects.emplace_back();
    ball.position = Vec3(0.05, 0.1, -0.17);
    ball.velocity = Vec3(0, 0, 9);
    ball.mass = 5;
    ObjectDescription& box = world.objects.emplace_back();
    box.shape = ObjectShape::Box;
    box.position = Vec3(1, 0.1, 0);
    return world;
}

/// A solver, and states that it has saved.
struct Subject {
    std::unique_ptr<Solver> solver;
    std::vector<Bytes> saved;
};

struct Setting {
    World world{described()};
    IncidentRing ring;
    std::vector<Subject> subjects;

    Setting() {
        add(std::make_unique<cpu::CpuSolver>(world, 1), true);
        add(std::make_unique<cpu::ReferenceSolver>(world), false);
    }

    void add(std::unique_ptr<Solver> solver, bool sleeps) {
        Subject& subject = subjects.emplace_back();
        solver->setIncidents(&ring);
        EventDescription push;
        push.body = kEveryBody;
        push.kind = EventDescription::Kind::Velocity;
        push.duration = 1;
        push.radius = 9;
        push.vector = {0.1, 0, 0};
        solver->push(world.makeEvent(push));
        // At the start, in the midst of the break, and later, when `cpu` has let something sleep.
        for (const int steps : {0, 13, sleeps ? 1487 : 37}) {
            solver->advance(steps);
            subject.saved.push_back(saveState(world, *solver));
        }
        if (sleeps && !(solver->asleep(0) || solver->asleep(1))) std::abort();
        subject.solver = std::move(solver);
    }
};

using fuzz::Input;

template <class Value>
void put(Bytes& bytes, std::size_t at, Value value) {
    if (at + sizeof value <= bytes.size()) std::memcpy(bytes.data() + at, &value, sizeof value);
}

void change(Bytes& bytes, Input& input) {
    const std::size_t at = input.below<std::uint32_t>(bytes.size());
    switch (input.take<std::uint8_t>() % 8) {
        case 0:
            put(bytes, at, input.take<std::uint8_t>());
            break;
        case 1:
            put(bytes, at, input.take<std::int32_t>());
            break;
        case 2:
            put(bytes, at, input.take<std::int64_t>());
            break;
        case 3:
            put(bytes, at, input.take<float>());
            break;
        case 4:
            put(bytes, at, input.take<double>());
            break;
        case 5:  // what is elsewhere in it
            put(bytes, at, bytes[input.below<std::uint32_t>(bytes.size())]);
            break;
        case 6:
            bytes.resize(std::max<std::size_t>(at, 1));
            break;
        default:
            bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                         input.take<std::uint8_t>() % 32, std::byte{1});
    }
}

void makeRight(Bytes& bytes) {
    if (bytes.size() < kHeader + kChecksum) return;
    put(bytes, kLengthAt, static_cast<std::uint64_t>(bytes.size()));
    put(bytes, bytes.size() - kChecksum, stateChecksum(bytes));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Setting setting;
    const World& world = setting.world;
    Input input(data, size);
    Subject& subject = setting.subjects[input.take<std::uint8_t>() % setting.subjects.size()];
    Solver& solver = *subject.solver;
    const std::uint8_t choice = input.take<std::uint8_t>();
    Bytes bytes = subject.saved[choice % subject.saved.size()];
    const Bytes& now = subject.saved[choice / 16 % subject.saved.size()];
    while (input.any()) change(bytes, input);
    if (choice < 240) makeRight(bytes);
    restoreState(world, solver, now);
    try {
        restoreState(world, solver, bytes);
    } catch (const InputError& error) {
        fuzz::checkSentence(error);
        if (saveState(world, solver) != now) std::abort();
        return 0;
    }
    solver.advance(9);  // two searches for contacts are among them
    diagnose(world, solver.state());
    for (const Incident& incident : setting.ring.take()) materialsOf(world, incident);
    return 0;
}
