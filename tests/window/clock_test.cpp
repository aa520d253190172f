// The viewer's clock, with time that the test makes up.
#include "view/clock.hpp"

#include <cmath>

#include "catch.hpp"

using sunder::view::Clock;

namespace {

constexpr double kStep = 1.0 / 3000;

/// Frames of `frame` s on a machine that takes `cost` s per step. Steps taken in all.
int play(Clock& clock, int frames, double frame, double cost) {
    int total = 0;
    for (int i = 0; i < frames; ++i) {
        const int steps = clock.tick(frame);
        clock.took(steps, steps * cost);
        total += steps;
    }
    return total;
}

}  // namespace

TEST_CASE("A machine that keeps up simulates as much time as passes", "[view]") {
    for (const double frame : {1.0 / 60, 1.0 / 144, 1.0 / 7, 0.0123}) {
        INFO("frame " << frame);
        Clock clock(kStep);
        const int frames = static_cast<int>(10 / frame);
        const int steps = play(clock, frames, frame, 1e-6);
        CHECK(steps * kStep == Approx(frames * frame).margin(2 * kStep));
        CHECK(clock.dropped() == 0);
        CHECK_FALSE(clock.behind());
    }
}

TEST_CASE("Slow motion simulates its share of time", "[view]") {
    Clock clock(kStep);
    clock.setSpeed(0.25);
    CHECK(play(clock, 600, 1.0 / 60, 1e-6) * kStep == Approx(2.5).margin(2 * kStep));
    clock.setSpeed(0);  // there is pause for that
    CHECK(clock.speed() == Clock::kSlowest);
    clock.setSpeed(5);
    CHECK(clock.speed() == 1);
}

TEST_CASE("A machine that is too slow leaves time out, and says so", "[view]") {
    // A step costs three times what it simulates: a frame takes as long as it takes, never longer
    // and longer.
    Clock clock(kStep);
    double frame = 1.0 / 60, elapsed = 0, simulated = 0, longest = 0;
    for (int i = 0; i < 300; ++i) {
        const int steps = clock.tick(frame);
        elapsed += frame;
        simulated += steps * kStep;
        const double work = steps * 3 * kStep;
        clock.took(steps, work);
        frame = work + 0.005;  // drawing
        if (i > 50) longest = std::max(longest, frame);
    }
    CHECK(longest < 0.15);
    CHECK(simulated < 0.4 * elapsed);
    CHECK(simulated > 0.2 * elapsed);
    CHECK(clock.behind());
    CHECK(clock.dropped() == Approx(elapsed - simulated).margin(0.01));

    // The load goes away: it catches up with the present, not with what it missed.
    const double dropped = clock.dropped();
    play(clock, 200, 1.0 / 60, 1e-6);
    CHECK_FALSE(clock.behind());
    const int steps = play(clock, 60, 1.0 / 60, 1e-6);
    CHECK(steps * kStep == Approx(1).margin(2 * kStep));
    CHECK(clock.dropped() - dropped < 3);
}

TEST_CASE("A stall is not made up for", "[view]") {
    Clock clock(kStep);
    play(clock, 10, 1.0 / 60, 1e-6);
    CHECK(clock.tick(20) * kStep <= Clock::kMostTime + kStep);
    CHECK(clock.tick(1.0 / 60) <= 51);
}

TEST_CASE("One slow frame does not make the next ones short for long", "[view]") {
    Clock clock(kStep);
    clock.took(clock.tick(1.0 / 60), 2.0);  // shaders compile
    play(clock, 30, 1.0 / 60, 1e-5);
    CHECK(clock.tick(1.0 / 60) >= 49);
}

TEST_CASE("A paused clock stands still but for single steps", "[view]") {
    Clock clock(kStep);
    clock.pause(true);
    CHECK(play(clock, 100, 1.0 / 60, 1e-6) == 0);
    clock.stepOnce(50);
    CHECK(clock.tick(1.0 / 60) == 50);
    CHECK(clock.tick(1.0 / 60) == 0);
    // Nothing is owed for the pause.
    clock.pause(false);
    CHECK(clock.tick(1.0 / 60) <= 51);
    CHECK(clock.dropped() == 0);
}

TEST_CASE("For a video each frame is as long as the others, however long it took", "[view]") {
    Clock clock(kStep);
    clock.setFixed(true);
    for (const double elapsed : {0.001, 3.0, 0.016}) CHECK(clock.tick(elapsed) == 50);
    clock.setSpeed(0.5);
    CHECK(clock.tick(1) == 25);
}

TEST_CASE("Slow motion in a video simulates its share of time, in whole substeps", "[view]") {
    // At a 64th of the speed and ten substeps a frame, six frames of seven simulate nothing.
    Clock clock(1.0 / 600);
    clock.setFixed(true);
    clock.setSpeed(Clock::kSlowest);
    int total = 0;
    for (int frame = 0; frame < 640; ++frame) total += clock.tick(0.1);
    CHECK(std::abs(total - 100) <= 1);
}

TEST_CASE("The time that a wall takes to build is not simulated", "[view]") {
    Clock clock(kStep);
    play(clock, 10, 1.0 / 60, 1e-6);
    clock.skip();
    CHECK(clock.tick(0.4) <= 51);
    CHECK(clock.dropped() == 0);
    CHECK(clock.tick(1.0 / 30) >= 99);  // from then on time counts as before
}
