// Sunder as a guest in a host's context: what the host has set does not show in what Sunder
// computes, and is afterwards as the host has set it.
#include "catch.hpp"
#include "gpu/guest.hpp"
#include "gpu/hostile_host.hpp"
#include "gpu/state_dump.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// A context with a host in it, and Sunder's guest driver there.
struct VisitedHost {
    explicit VisitedHost(window::Profile profile = window::Profile::Core)
        : context(window::createHeadlessContext(profile)),
          guest(context->loadFunction(), "a host's", gl::Driver::Owner::Host) {}
    std::unique_ptr<window::Context> context;
    HostileHost host;
    gl::Driver guest;
};

/// Runs `call`, and checks that the host finds its state and its error as they were.
template <class Call>
void checkUnnoticed(VisitedHost& visited, const char* what, Call call) {
    INFO(what);
    const StateDump before = dumpState();
    visited.context->takeErrors();  // which asking for more than a driver knows has left
    call();
    CHECK(gl::Driver::current() == &visited.context->driver());
    CHECK(visited.context->takeErrors() == std::vector<std::string>{});
    CHECK(differences(before, dumpState()) == std::vector<std::string>{});
    visited.context->takeErrors();
}

/// The same for all that a solver does.
template <class Solver>
void checkSame(VisitedHost& visited, Guest<Solver>& solver, std::uint64_t expected) {
    checkUnnoticed(visited, "restart", [&] { solver.restart(); });
    for (const int steps : kPieces)
        checkUnnoticed(visited, "advance", [&] { solver.advance(steps); });
    checkUnnoticed(visited, "state", [&] { CHECK(solver.hash() == expected); });
}

template <class Solver>
std::uint64_t undisturbed() {
    static const std::uint64_t hash = [] {
        const auto context = window::createHeadlessContext();
        Guest<Solver> solver(context->driver(), guestWorld(), gl::Visit::State::Ours);
        return hashOf(solver);
    }();
    return hash;
}

template <class Solver>
void checkEverySetting(window::Profile profile) {
    const std::uint64_t expected = undisturbed<Solver>();
    VisitedHost visited(profile);
    const StateDump fresh = dumpState();
    const std::uint64_t contents = visited.host.contents();
    std::optional<Guest<Solver>> solver;
    checkUnnoticed(visited, "made", [&] { solver.emplace(visited.guest); });
    for (const HostileHost::Setting& setting : visited.host.settings()) {
        INFO(setting.name);
        setting.set(visited.host);
        checkSame(visited, *solver, expected);
        visited.host.reset();
        REQUIRE(differences(fresh, dumpState()) == std::vector<std::string>{});
    }
    visited.host.setAll();
    checkSame(visited, *solver, expected);
    checkUnnoticed(visited, "gone", [&] { solver.reset(); });
    visited.host.reset();
    CHECK(visited.host.contents() == contents);
}

/// Made in each of the settings, then in all at the same time.
template <class Solver>
void checkMadeIn(const std::vector<HostileHost::Setting>& settings) {
    const std::uint64_t expected = undisturbed<Solver>();
    VisitedHost visited;
    const std::uint64_t contents = visited.host.contents();
    const auto check = [&] {
        std::optional<Guest<Solver>> solver;
        checkUnnoticed(visited, "made", [&] { solver.emplace(visited.guest); });
        CHECK(hashOf(*solver) == expected);
        checkUnnoticed(visited, "gone", [&] { solver.reset(); });
        visited.host.reset();
    };
    for (const HostileHost::Setting& setting : settings) {
        INFO(setting.name);
        setting.set(visited.host);
        check();
    }
    visited.host.setAll();
    check();
    CHECK(visited.host.contents() == contents);
}

}  // namespace

TEST_CASE("the world of these tests breaks, and its ball is stopped") {
    const auto context = window::createHeadlessContext();
    Guest<gpu::GatherSolver> solver(context->driver(), guestWorld(), gl::Visit::State::Ours);
    const State before = solver.state();
    for (const int steps : kPieces) solver.advance(steps);
    const State after = solver.state();
    CHECK(diagnose(guestWorld(), after).bondsBroken > 5);
    CHECK(after.objects[0].velocity[2] > before.objects[0].velocity[2] + 0.1);
    CHECK(solver.incidents().size() > 5);
}

TEST_CASE("no state of a host's changes what gather computes, nor is it changed") {
    checkEverySetting<gpu::GatherSolver>(window::Profile::Core);
}
TEST_CASE("no state of a host's changes what scatter computes, nor is it changed") {
    checkEverySetting<gpu::ScatterSolver>(window::Profile::Core);
}
TEST_CASE("no state of a host's changes what compute computes, nor is it changed") {
    checkEverySetting<gpu::ComputeSolver>(window::Profile::Core);
}

TEST_CASE("nor does what only a compatibility profile has", "[long]") {
    std::unique_ptr<window::Context> context;
    try {
        context = window::createHeadlessContext(window::Profile::Compatibility);
    } catch (const DeviceError& error) {
        WARN("left out: this driver has no compatibility profile: " << error.what());
        return;
    }
    CHECK(context->info().compatibility);
    context.reset();
    checkEverySetting<gpu::GatherSolver>(window::Profile::Compatibility);
    checkEverySetting<gpu::ScatterSolver>(window::Profile::Compatibility);
}

TEST_CASE("solvers made in the worst of contexts compute the same") {
    checkMadeIn<gpu::GatherSolver>({});
    checkMadeIn<gpu::ComputeSolver>({});
    checkMadeIn<gpu::ScatterSolver>({});
}
TEST_CASE("solvers made in any state of a context compute the same", "[long]") {
    const std::vector<HostileHost::Setting> settings = [] {
        VisitedHost visited;
        return visited.host.settings();
    }();
    checkMadeIn<gpu::GatherSolver>(settings);
    checkMadeIn<gpu::ScatterSolver>(settings);
}

TEST_CASE("where nothing is put back, results are the same, and functions are the host's again") {
    const std::uint64_t expected = undisturbed<gpu::GatherSolver>();
    VisitedHost visited;
    for (const HostileHost::Setting& setting : visited.host.settings())
        if (setting.name.find("transform feedback") == std::string::npos) setting.set(visited.host);
    Guest<gpu::GatherSolver> solver(visited.guest, guestWorld(), gl::Visit::State::Dirty);
    CHECK(gl::Driver::current() == &visited.context->driver());
    for (const int steps : kPieces) {
        for (const HostileHost::Setting& setting : visited.host.settings())
            if (setting.name.find("transform feedback") == std::string::npos &&
                setting.name != "a query of time")
                setting.set(visited.host);
        solver.advance(steps);
    }
    CHECK(solver.hash() == expected);
    visited.host.reset();
}

TEST_CASE("the host's queries and its deleted program are refused, and nothing is changed") {
    VisitedHost visited;
    std::optional<Guest<gpu::GatherSolver>> solver;
    solver.emplace(visited.guest);
    const auto checkRefused = [&](const std::string& part) {
        checkUnnoticed(visited, part.c_str(), [&] {
            CHECK_THROWS_AS(solver->advance(1), InputError);
            CHECK_THROWS_WITH(solver->advance(1),
                              Catch::Contains(part) && Catch::Contains("before Sunder is called"));
        });
    };
    for (const auto& [target, name] :
         {std::pair{GL_SAMPLES_PASSED, "GL_SAMPLES_PASSED"},
          std::pair{GL_ANY_SAMPLES_PASSED, "GL_ANY_SAMPLES_PASSED"},
          std::pair{GL_PRIMITIVES_GENERATED, "GL_PRIMITIVES_GENERATED"},
          std::pair{GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN,
                    "GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN"}}) {
        GLuint query = 0;
        glGenQueries(1, &query);
        glBeginQuery(static_cast<GLenum>(target), query);
        checkRefused(name);
        glEndQuery(static_cast<GLenum>(target));
        glDeleteQueries(1, &query);
    }
    glUseProgram(visited.host.program);
    glDeleteProgram(visited.host.program);
    checkRefused("has been deleted");
    CHECK(glIsProgram(visited.host.program));
    glUseProgram(0);
    CHECK_NOTHROW(solver->advance(1));
    // What only deletes is never refused.
    glBeginQuery(GL_SAMPLES_PASSED, visited.host.query);
    checkUnnoticed(visited, "gone", [&] { solver.reset(); });
    glEndQuery(GL_SAMPLES_PASSED);
}

TEST_CASE("an error that the host has pending stays, unless Sunder is told to ask") {
    VisitedHost visited;
    Guest<gpu::GatherSolver> solver(visited.guest);
    const auto raise = [] { glEnable(GL_TEXTURE_2D + 0x7000); };
    raise();
    solver.advance(3);
    const std::uint64_t hash = solver.hash();
    CHECK(glGetError() == GL_INVALID_ENUM);
    CHECK(glGetError() == GL_NO_ERROR);
    CHECK(visited.guest.takeHostErrors().empty());

    visited.guest.askErrors(true);
    raise();
    solver.restart();
    CHECK(glGetError() == GL_NO_ERROR);
    CHECK(visited.guest.takeHostErrors() == std::vector<std::string>{"GL_INVALID_ENUM"});
    CHECK(visited.guest.takeHostErrors().empty());
    solver.advance(3);
    CHECK(solver.hash() == hash);
    SECTION("conditional rendering is then noticed") {
        GLuint query = 0;
        glGenQueries(1, &query);
        glBeginQuery(GL_SAMPLES_PASSED, query);
        glEndQuery(GL_SAMPLES_PASSED);
        glBeginConditionalRender(query, GL_QUERY_WAIT);
        CHECK_THROWS_WITH(solver.advance(1), Catch::Contains("conditional rendering is active"));
        glEndConditionalRender();
        CHECK_NOTHROW(solver.advance(1));
        glDeleteQueries(1, &query);
    }
}

TEST_CASE("as a guest, memory that is missing is noticed without asking for errors") {
    VisitedHost visited;
    const gl::Visit visit(visited.guest);
    const std::size_t bytes = std::size_t{1} << 60;
    CHECK_THROWS_WITH(gl::Buffer(bytes, nullptr, GL_STATIC_DRAW, "numbers"),
                      Catch::Contains("no memory for the numbers"));
}

TEST_CASE("a visit within a visit does nothing, and one without a context of its own ends") {
    VisitedHost visited;
    visited.host.setAll();
    checkUnnoticed(visited, "nested", [&] {
        const gl::Visit outer(visited.guest);
        CHECK(gl::Driver::current() == &visited.guest);
        CHECK_FALSE(glIsEnabled(GL_RASTERIZER_DISCARD));
        {
            const gl::Visit inner(visited.guest);
            CHECK(gl::Driver::current() == &visited.guest);
        }
        CHECK(gl::Driver::current() == &visited.guest);
        CHECK_FALSE(glIsEnabled(GL_RASTERIZER_DISCARD));
    });
    visited.host.reset();
}
