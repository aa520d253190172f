// Worlds in several contexts: in turn, one after the other, at the same time. Nothing of GL belongs
// to the process.
#include <thread>

#include "catch.hpp"
#include "gpu/guest.hpp"
#include "gpu/object_count.hpp"
#include "support/object_worlds.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

/// A context of a host's, and Sunder's guest driver there.
struct Place {
    std::unique_ptr<window::Context> context = window::createHeadlessContext();
    gl::Driver guest{context->loadFunction(), "a host's", gl::Driver::Owner::Host};
};

std::uint64_t hashAlone() {
    Place place;
    Guest<gpu::GatherSolver> solver(place.guest);
    return hashOf(solver);
}

/// What a hundred of are made.
const World& tinyWorld() {
    static const World world = [] {
        WorldDescription d = block({2, 2, 1}, brittle());
        d.contact = true;
        d.events = {hit(0, {0, 0.1, 0}, {0, 0, 5})};
        d.objects = {ball(0.1, 1, {0, 0.1, 0.16}, {0, 0, -5})};
        return World(d);
    }();
    return world;
}

template <class Solver>
void makeAndDrop(int worlds) {
    Place place;
    ObjectCount count(place.guest.functions());
    std::uint64_t first = 0;
    for (int i = 0; i < worlds; ++i) {
        {
            Guest<Solver> solver(place.guest, tinyWorld());
            solver.advance(7);
            const std::uint64_t hash = solver.hash();
            if (i == 0) first = hash;
            CHECK(hash == first);
            CHECK(count.alive() > 20);
        }
        CHECK(count.alive() == 0);
    }
    place.context->check();
}

}  // namespace

TEST_CASE("worlds in two contexts are advanced in turn and know nothing of each other") {
    const std::uint64_t expected = hashAlone();
    Place a, b;
    std::optional<Guest<gpu::GatherSolver>> first, second;
    a.context->makeCurrent();
    first.emplace(a.guest);
    b.context->makeCurrent();
    second.emplace(b.guest);
    for (const int steps : kPieces) {
        a.context->makeCurrent();
        first->advance(steps);
        b.context->makeCurrent();
        second->advance(steps);
    }
    CHECK(second->hash() == expected);
    second.reset();
    b.context->check();
    a.context->makeCurrent();
    CHECK(first->hash() == expected);
    first.reset();
    a.context->check();
}

TEST_CASE("a context that is destroyed and made again has the same results") {
    const std::uint64_t expected = hashAlone();
    CHECK(hashAlone() == expected);
    CHECK(gl::Driver::current() == nullptr);
}

TEST_CASE("objects that outlive their context are let go, and nothing is called") {
    std::optional<gl::Buffer> buffer;
    std::optional<gl::Fence> fence;
    {
        const auto context = window::createHeadlessContext();
        buffer.emplace(std::size_t{16}, nullptr, GL_STATIC_DRAW, "numbers");
        fence = gl::Fence::insert();
    }
    CHECK_NOTHROW(buffer.reset());
    CHECK_NOTHROW(fence.reset());
}

TEST_CASE("a world that outlives the host's context is let go of when it is told") {
    auto context = window::createHeadlessContext();
    gl::Driver guest(context->loadFunction(), "a host's", gl::Driver::Owner::Host);
    std::optional<Guest<gpu::GatherSolver>> solver;
    solver.emplace(guest);
    context.reset();
    guest.contextGone();
    CHECK_THROWS_AS(solver->advance(1), DeviceError);
    CHECK_THROWS_WITH(solver->advance(1), Catch::Contains("has been destroyed"));
    // Without a context, a call would end the program.
    gl::Functions none{};
    guest.functions() = none;
    CHECK_NOTHROW(solver.reset());
    CHECK(gl::Driver::current() == nullptr);
}

TEST_CASE("worlds that are made and dropped leave no GL object behind") {
    makeAndDrop<gpu::GatherSolver>(4);
    makeAndDrop<gpu::ScatterSolver>(4);
}
TEST_CASE("nor do a hundred of them", "[long]") {
    makeAndDrop<gpu::GatherSolver>(100);
}

TEST_CASE("two threads each have a world in a context of their own") {
    const std::uint64_t expected = hashAlone();
    std::uint64_t hashes[2] = {};
    std::string problems[2];
    std::thread threads[2];
    for (int i = 0; i < 2; ++i)
        threads[i] = std::thread([&, i] {
            try {
                hashes[i] = hashAlone();
            } catch (const std::exception& error) {
                problems[i] = error.what();
            }
        });
    for (std::thread& thread : threads) thread.join();
    for (int i = 0; i < 2; ++i) {
        CHECK(problems[i].empty());
        CHECK(hashes[i] == expected);
    }
}
