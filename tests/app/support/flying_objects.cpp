#include "app/support/flying_objects.hpp"

#include <cmath>

#include "app/support/scenes.hpp"
#include "catch.hpp"

namespace flying {
namespace {

using nlohmann::json;

void checkVector(const json& found, const std::vector<double>& expected) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        CHECK(found[i].get<double>() == Approx(expected[i]).margin(kTolerance));
}

}  // namespace

std::string scene() {
    return scenes::kFalling + R"(
[[object]]
name = "ball"
shape = "sphere"
radius = 0.1
mass = 2
drag = 0
position = [3, 5, 0]
velocity = [6, 0, -1]
spin = [0, 4, 0]
[[object]]
name = "post"
shape = "box"
size = [0.2, 1, 0.2]
fixed = true
position = [-3, 0.5, 0]
[[object]]
name = "late"
shape = "sphere"
radius = 0.1
mass = 1
[[event]]
kind = "throw"
time = 10
object = "late"
from = [0, 3, 5]
velocity = [0, 0, -9]
)";
}

void check(const json& report) {
    const json& objects = report.at("objects");
    REQUIRE(objects.size() == 3);
    const json &ball = objects[0], &post = objects[1], &late = objects[2];
    CHECK(ball.at("name") == "ball");
    CHECK(ball.at("present") == true);
    CHECK(ball.at("fixed") == false);
    // 250 steps of symplectic Euler: the nth lowers it by n·g·h².
    const double h = 1. / 3000, time = 250 * h, g = 9.81;
    checkVector(ball.at("position"), {3 + 6 * time, 5 - g * h * h * 250 * 251 / 2, -time});
    checkVector(ball.at("velocity"), {6, -g * time, -1});
    checkVector(ball.at("spin"), {0, 4, 0});
    // About y by 4 rad/s; x, y, z, w.
    checkVector(ball.at("orientation"), {0, std::sin(2 * time), 0, std::cos(2 * time)});

    CHECK(post.at("name") == "post");
    CHECK(post.at("present") == true);
    CHECK(post.at("fixed") == true);
    checkVector(post.at("position"), {-3, 0.5, 0});
    checkVector(post.at("velocity"), {0, 0, 0});
    checkVector(post.at("spin"), {0, 0, 0});
    checkVector(post.at("orientation"), {0, 0, 0, 1});

    CHECK(late.at("name") == "late");
    CHECK(late.at("present") == false);
    CHECK(late.at("fixed") == false);
    for (const char* what : {"position", "orientation", "velocity", "spin"})
        CHECK(late.at(what).is_null());
}

}  // namespace flying
