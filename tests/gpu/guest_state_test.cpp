// Sunder as a guest in a host's context: what the host has set does not show in what Sunder
// computes, and is afterwards as the host has set it.
#include "catch.hpp"
#include "gpu/guest.hpp"
#include "gpu/hostile_host.hpp"
#include "gpu/state_dump.hpp"

using namespace sunder;

namespace {

/// A context with a host in it, and Sunder's guest driver there.
struct Scene {
    explicit Scene(gl::Profile profile = gl::Profile::Core)
        : context(gl::createHeadlessContext(profile)),
          guest(context->loadFunction(), "a host's", gl::Driver::Owner::Host) {}
    std::unique_ptr<gl::Context> context;
    HostileHost host;
    gl::Driver guest;
};

/// Runs `call`, and checks that the host finds its state and its error as they were.
template <class Call>
void checkUnnoticed(Scene& scene, const char* what, Call call) {
    INFO(what);
    const StateDump before = dumpState();
    scene.context->takeErrors();  // which asking for more than a driver knows has left
    call();
    CHECK(gl::Driver::current() == &scene.context->driver());
    CHECK(scene.context->takeErrors() == std::vector<std::string>{});
    CHECK(differences(before, dumpState()) == std::vector<std::string>{});
    scene.context->takeErrors();
}

/// The same for all that a solver does.
template <class Solver>
void checkSame(Scene& scene, Guest<Solver>& solver, std::uint64_t expected) {
    checkUnnoticed(scene, "restart", [&] { solver.restart(); });
    for (const int steps : kPieces)
        checkUnnoticed(scene, "advance", [&] { solver.advance(steps); });
    checkUnnoticed(scene, "state", [&] { CHECK(solver.hash() == expected); });
}

template <class Solver>
std::uint64_t undisturbed() {
    static const std::uint64_t hash = [] {
        const auto context = gl::createHeadlessContext();
        Guest<Solver> solver(context->driver(), guestWorld(), gl::Visit::State::Ours);
        return hashOf(solver);
    }();
    return hash;
}

template <class Solver>
void checkEverySetting(gl::Profile profile) {
    const std::uint64_t expected = undisturbed<Solver>();
    Scene scene(profile);
    const StateDump fresh = dumpState();
    const std::uint64_t contents = scene.host.contents();
    std::optional<Guest<Solver>> solver;
    checkUnnoticed(scene, "made", [&] { solver.emplace(scene.guest); });
    for (const HostileHost::Setting& setting : scene.host.settings()) {
        INFO(setting.name);
        setting.set(scene.host);
        checkSame(scene, *solver, expected);
        scene.host.reset();
        REQUIRE(differences(fresh, dumpState()) == std::vector<std::string>{});
    }
    scene.host.setAll();
    checkSame(scene, *solver, expected);
    checkUnnoticed(scene, "gone", [&] { solver.reset(); });
    scene.host.reset();
    CHECK(scene.host.contents() == contents);
}

template <class Solver>
void checkMadeInEverySetting() {
    const std::uint64_t expected = undisturbed<Solver>();
    Scene scene;
    const std::uint64_t contents = scene.host.contents();
    const auto check = [&] {
        std::optional<Guest<Solver>> solver;
        checkUnnoticed(scene, "made", [&] { solver.emplace(scene.guest); });
        CHECK(hashOf(*solver) == expected);
        checkUnnoticed(scene, "gone", [&] { solver.reset(); });
        scene.host.reset();
    };
    for (const HostileHost::Setting& setting : scene.host.settings()) {
        INFO(setting.name);
        setting.set(scene.host);
        check();
    }
    scene.host.setAll();
    check();
    CHECK(scene.host.contents() == contents);
}

}  // namespace

TEST_CASE("the world of these tests breaks, and its ball is stopped") {
    const auto context = gl::createHeadlessContext();
    Guest<gpu::GatherSolver> solver(context->driver(), guestWorld(), gl::Visit::State::Ours);
    const State before = solver.state();
    for (const int steps : kPieces) solver.advance(steps);
    const State after = solver.state();
    CHECK(diagnose(guestWorld(), after).bondsBroken > 5);
    CHECK(after.objects[0].velocity[2] > before.objects[0].velocity[2] + 0.1);
}

TEST_CASE("no state of a host's changes what gather computes, nor is it changed") {
    checkEverySetting<gpu::GatherSolver>(gl::Profile::Core);
}
TEST_CASE("no state of a host's changes what scatter computes, nor is it changed") {
    checkEverySetting<gpu::ScatterSolver>(gl::Profile::Core);
}
