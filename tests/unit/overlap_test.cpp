// What may be in what when the world begins (core/overlap.hpp), and how it is found.
#include "core/overlap.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <set>

#include "catch.hpp"
#include "core/box_gap.hpp"
#include "core/contact.hpp"
#include "support/scene_text.hpp"
#include "support/worlds.hpp"

using namespace sunder;
using namespace sunder::core;

namespace {

RoundedBox sharp(const Vec3& centre, const Vec3& half, const Mat3& axes = Mat3::Identity()) {
    return {centre, axes, half, 0};
}

RoundedBox randomBox(Random& random) {
    RoundedBox box{random.vector(), random.rotation(), Vec3::Zero(), 0};
    // Points and lines, too.
    for (double& half : box.half) half = std::max(0.0, random());
    box.radius = 0.2 * (random() + 1);
    return box;
}

/// As touchOf() finds it, but until it has.
double distanceByProjection(const RoundedBox& a, const RoundedBox& b) {
    Vec3 x = a.centre, y = b.nearest(x);
    for (int i = 0; i < 20000; ++i) {
        x = a.nearest(y);
        y = b.nearest(x);
    }
    return (x - y).norm();
}

BodyDescription cube(const Vec3& position, int cells = 2) {
    BodyDescription body;
    body.name = "cube";
    body.cells.setConstant(cells);
    body.size.setConstant(0.1 * cells);
    body.position = position;
    return body;
}

ObjectDescription sphere(const Vec3& position, double radius = 0.1) {
    ObjectDescription object;
    object.name = "ball";
    object.halfSize.setConstant(radius);
    object.position = position;
    return object;
}

/// Bodies in a world with a floor, and with contact.
WorldDescription worldOf(std::vector<BodyDescription> bodies,
                         std::vector<ObjectDescription> objects = {}) {
    WorldDescription d = block({1, 1, 1}, softElastic());
    d.bodies = std::move(bodies);
    for (std::size_t i = 0; i < d.bodies.size(); ++i)
        d.bodies[i].name += " " + std::to_string(i + 1);
    d.objects = std::move(objects);
    for (std::size_t i = 0; i < d.objects.size(); ++i)
        d.objects[i].name += " " + std::to_string(i + 1);
    d.ground = d.contact = true;
    return d;
}

std::string refusal(const WorldDescription& d) {
    return messageOf([&] { const World world(d); });
}

std::int64_t volume(const std::vector<Box>& boxes, const Vec3& edges) {
    double sum = 0;
    for (const Box& box : boxes) sum += (box.high - box.low).cwiseQuotient(edges).prod();
    return std::llround(sum);
}

}  // namespace

TEST_CASE("the gap of two rounded boxes is what geometry says") {
    const Vec3 one(1, 1, 1), none(0, 0, 0);
    const Mat3 turned = Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitZ()).toRotationMatrix();
    // Balls, 3 m apart and 0.5 m in each other.
    CHECK(gapBetween({none, Mat3::Identity(), none, 1}, {{5, 0, 0}, Mat3::Identity(), none, 1}) ==
          Approx(3));
    CHECK(gapBetween({none, Mat3::Identity(), none, 1},
                     {{0.9, 1.2, 0}, Mat3::Identity(), none, 1}) == Approx(-0.5));
    // A ball at a corner, 0.1 m in it; the face's normal alone would say 0.5.
    const Vec3 diagonal = one / std::sqrt(3.0);
    CHECK(gapBetween(sharp(none, one), {one + 0.4 * diagonal, Mat3::Identity(), none, 0.5}) ==
          Approx(-0.1));
    // A ball with its centre in a box: to the nearest face and its radius.
    CHECK(gapBetween(sharp(none, one), {{0.7, 0.1, -0.5}, turned, none, 0.5}) == Approx(-0.8));
    // Boxes, face to face, and one on its edge.
    CHECK(gapBetween(sharp(none, one), sharp({0.2, 1.75, 0.3}, one)) == Approx(-0.25));
    CHECK(gapBetween(sharp(none, one), sharp({0.2, 2.3, 0.3}, one, turned)) ==
          Approx(1.3 - std::sqrt(2.0)));
    // Two edges across each other.
    const Mat3 up = Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX()).toRotationMatrix();
    CHECK(gapBetween({none, up, {5, 1, 1}, 0.1}, {{0, 0, 3}, turned * up, {5, 1, 1}, 0.1}) ==
          Approx(3 - 2 * std::sqrt(2.0) - 0.2));
    // Lines: crossing with a gap between, and cutting each other.
    CHECK(gapBetween({none, Mat3::Identity(), {1, 0, 0}, 0.2},
                     {{0, 0.3, 0.3}, Mat3::Identity(), {0, 1, 0}, 0.2}) == Approx(-0.1));
    CHECK(gapBetween({none, Mat3::Identity(), {1, 0, 0}, 0.2},
                     {{0, 0.3, 0}, Mat3::Identity(), {0, 1, 0}, 0.2}) == Approx(-0.4));
}

TEST_CASE("the gap of any two rounded boxes is their distance, or the shortest way out") {
    Random random(5);
    int apart = 0, within = 0;
    for (int i = 0; i < 3000; ++i) {
        const RoundedBox a = randomBox(random), b = randomBox(random);
        const double gap = gapBetween(a, b), radii = a.radius + b.radius;
        CHECK(gapBetween(b, a) == Approx(gap).margin(1e-12));
        if (gap > 0) continue;
        if (gap > -radii + 1e-6) {
            ++apart;
            // Projection comes nearer for ever; what is left after so many steps is less than this.
            CHECK(distanceByProjection(a, b) - radii == Approx(gap).margin(1e-5));
            continue;
        }
        ++within;
        // No way that is shorter leads out.
        for (int way = 0; way < 20; ++way) {
            RoundedBox moved = b;
            moved.centre += 0.999 * -gap * random.vector().normalized();
            CHECK(gapBetween(a, moved) < 1e-9);
        }
    }
    CHECK(apart > 200);
    CHECK(within > 200);
}

TEST_CASE("boxes that overlap are found, each pair once, and few others looked at") {
    Random random(9);
    std::vector<Box> boxes;
    for (int i = 0; i < 700; ++i) {
        const Vec3 centre = random.vector(), half = 0.1 * random.vector().cwiseAbs();
        boxes.push_back({centre - half, centre + half});
    }
    std::set<std::pair<int, int>> found, expected;
    const std::int64_t compared = forEachOverlap(boxes, [&](int a, int b) {
        CHECK(a < b);
        CHECK(found.insert({a, b}).second);
    });
    for (int a = 0; a < 700; ++a)
        for (int b = a + 1; b < 700; ++b)
            if (boxes[a].overlaps(boxes[b])) expected.insert({a, b});
    CHECK(found == expected);
    CHECK(found.size() > 100);
    CHECK(compared < 700 * 699 / 2 / 5);
    CHECK(forEachOverlap({}, [](int, int) { FAIL(); }) == 0);
}

TEST_CASE("a body is as few boxes as its holes allow") {
    BodyDescription wall;
    wall.cells = {30, 20, 2};
    wall.size = {3, 2, 0.2};
    wall.position = {1, 5, 2};
    REQUIRE(boxesOf(wall).size() == 1);
    CHECK((boxesOf(wall)[0].low - Vec3(-0.5, 5, 1.9)).norm() < 1e-12);
    CHECK((boxesOf(wall)[0].high - Vec3(2.5, 7, 2.1)).norm() < 1e-12);
    wall.regions = {{{12, 0, 0}, {17, 14, 1}, -1}};  // a door
    CHECK(boxesOf(wall).size() == 3);
    CHECK(volume(boxesOf(wall), {0.1, 0.1, 0.1}) == 30 * 20 * 2 - 6 * 15 * 2);
    wall.regions.push_back({{13, 3, 0}, {14, 3, 0}, 0});  // and something in it
    CHECK(boxesOf(wall).size() > 3);
    CHECK(volume(boxesOf(wall), {0.1, 0.1, 0.1}) == 30 * 20 * 2 - 6 * 15 * 2 + 2);
    const std::vector<Box> boxes = boxesOf(wall);
    // They share faces, which are where they are up to rounding.
    forEachOverlap(boxes, [&](int a, int b) {
        const Vec3 depth =
            boxes[a].high.cwiseMin(boxes[b].high) - boxes[a].low.cwiseMax(boxes[b].low);
        CHECK(depth.minCoeff() < 1e-12);
    });
}

TEST_CASE("overlaps of a thousand bodies and of a million cells are found without all pairs") {
    const auto compared = [](int n) {
        std::vector<BodyDescription> bodies;
        for (int i = 0; i < n * n * n; ++i)  // face on face
            bodies.push_back(cube(0.2 * Vec3(i % n, i / n % n, i / (n * n))));
        return startOverlaps(worldOf(std::move(bodies))).compared;
    };
    const std::int64_t thousand = compared(10), eight = compared(20);
    CAPTURE(thousand, eight);
    CHECK(thousand < 40 * 1000);   // of 499,500
    CHECK(eight < 12 * thousand);  // n·log n: 10.4 times; n²: 64 times

    // Walls of half a million cells with doors, one behind the other, and a ball before them.
    std::vector<BodyDescription> walls(2, cube({0, 0, 0}));
    for (int i = 0; i < 2; ++i) {
        walls[i].cells = {1000, 500, 1};
        walls[i].size = {100, 50, 0.1};
        walls[i].position = {0, 0, 0.1 * i};
        walls[i].regions = {{{10, 0, 0}, {20, 30, 0}, -1}};
    }
    CHECK(startOverlaps(worldOf(walls, {sphere({0, 5, 1})})).compared < 50);

    // Two combs with thousands of teeth, in each other's gaps.
    std::vector<BodyDescription> combs(2, cube({0, 0, 0}));
    for (int i = 0; i < 2; ++i) {
        combs[i].cells = {256, 40, 40};
        combs[i].size = 0.1 * combs[i].cells.cast<double>();
        for (int slot = 0; slot < 127; ++slot)
            combs[i].regions.push_back({{2 * slot + 1 - i, 1, 0}, {2 * slot + 1 - i, 39, 39}, -1});
        for (int slot = 0; slot < 20; ++slot)
            combs[i].regions.push_back({{0, 1, 2 * slot}, {255, 39, 2 * slot}, -1});
    }
    combs[1].position = {0, 0.1, 0};
    combs[1].regions.push_back({{0, 0, 0}, {255, 0, 39}, -1});
    combs[1].regions.push_back({{254, 0, 0}, {255, 39, 39}, -1});
    const auto teeth =
        static_cast<std::int64_t>(boxesOf(combs[0]).size() + boxesOf(combs[1]).size());
    CHECK(teeth > 5000);
    CHECK(refusal(worldOf(combs)).empty());
    CHECK(startOverlaps(worldOf(combs)).compared < 60 * teeth);  // each has neighbours on all sides
}

TEST_CASE("what is in something when the world begins is refused: who, in what, how deep") {
    const std::string gently = "overlap = \"allow\"";
    const auto check = [&](const WorldDescription& d, const std::vector<std::string>& parts) {
        checkParts(refusal(d), parts);
        checkParts(refusal(d), {"when the world begins", gently});
    };
    check(worldOf({cube({0, -0.05, 0})}),
          {"body 'cube 1' reaches 0.05 m below the ground at y = 0"});
    check(worldOf({cube({0, 0, 0}), cube({0.15, 0.01, 0})}),
          {"body 'cube 2' and body 'cube 1' overlap by 0.05 m"});
    check(worldOf({cube({0, 0, 0})}, {sphere({3, -3, 0})}),
          {"object 'ball 1' reaches 3.1 m below the ground"});
    check(worldOf({cube({0, 0, 0})}, {sphere({0.15, 0.1, 0})}),
          {"object 'ball 1' and body 'cube 1' overlap by 0.05 m"});
    check(worldOf({cube({0, 0, 0})}, {sphere({3, 1, 0}), sphere({3.09, 1.12, 0})}),
          {"object 'ball 2' and object 'ball 1' overlap by 0.05 m"});
    WorldDescription room = worldOf({cube({0, 0, 0})}, {sphere({0, 1, 0})});
    room.room = RoomDescription{{-2, 2}, {-1, 1}, 0.5, 1.5};
    CHECK(refusal(room).empty());
    room.objects[0].position = Vec3(-2.4, 1, 0);
    check(room, {"object 'ball 1' reaches 0.5 m beyond the room's wall at x = -2 m"});
    room.objects[0].position = Vec3(0, 1, 0.95);
    check(room, {"object 'ball 1' reaches 0.05 m beyond the room's wall at z = 1 m"});
    room.objects[0].position = Vec3(0, 2, 0);
    check(room, {"object 'ball 1' reaches 0.6 m above the room's ceiling at 1.5 m"});
    room.objects.clear();
    room.bodies[0].position = {1.95, 0, 0};
    check(room, {"body 'cube 1' reaches 0.05 m beyond the room's wall at x = 2 m"});
    // A capsule on its side, half a metre long: turned upright it would reach into the ground.
    WorldDescription lying = worldOf({cube({2, 0, 0})}, {sphere({0, 0.1, 0})});
    lying.objects[0].shape = ObjectShape::Capsule;
    lying.objects[0].halfSize = {0.1, 0.25, 0.1};
    lying.objects[0].orientation = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ());
    CHECK(refusal(lying).empty());
    lying.objects[0].orientation.setIdentity();
    check(lying, {"object 'ball 1' reaches 0.15 m below the ground"});
    // A fixed object and a body; two that are fixed, or one and the ground, do not touch.
    WorldDescription fixed = worldOf({cube({0, 0, 0})}, {sphere({0, 0, 0}), sphere({0, 0, 0.05})});
    for (ObjectDescription& object : fixed.objects) object.fixed = true;
    check(fixed, {"object 'ball 1' and body 'cube 1' overlap by 0."});
    fixed.bodies[0].position = {1, 0, 0};
    CHECK(refusal(fixed).empty());
}

TEST_CASE("what merely touches, or is nowhere, or does not push, may be where it is") {
    // Faces at places that no binary number has.
    std::vector<BodyDescription> stack;
    for (int i = 0; i < 20; ++i) stack.push_back(cube({0.1, 0.2 * i, 3000.7}));
    CHECK(refusal(worldOf(stack)).empty());
    // A hundredth of the smaller edge, but no more than a spring makes a parting speed of.
    const double spring = 1. / 3000 / std::sqrt(kContactStiffness);  // 0.96 mm
    for (const double edge : {0.02, 0.1, 1.0}) {
        const double tolerated = std::min(0.01 * std::min(edge, 0.1), spring);
        for (const double share : {0.95, 1.05}) {
            BodyDescription small = cube({0, 2 - share * tolerated, 0}, 2);
            small.size.setConstant(2 * edge);
            CHECK(refusal(worldOf({cube({0, 0, 0}, 20), small})).empty() == (share < 1));
        }
    }
    for (const double share : {0.95, 1.05}) {
        const WorldDescription d = worldOf({cube({0, -share * 1e-3, 0})});
        CHECK(refusal(d).empty() == (share < 1));
        const WorldDescription e = worldOf({cube({0, 0, 0})}, {sphere({1, 0.1 - share * 2e-3, 0})});
        CHECK(refusal(e).empty() == (share < 1));
    }
    // In a hole of another.
    BodyDescription frame = cube({0, 0, 0}, 4), inside = cube({0, 0.1, 0});
    CHECK(!refusal(worldOf({frame, inside})).empty());
    frame.regions = {{{1, 1, 0}, {2, 2, 3}, -1}};
    CHECK(refusal(worldOf({frame, inside}, {sphere({0, 0.2, -0.2})})).empty());
    frame.regions[0].from = {1, 2, 0};
    CHECK(!refusal(worldOf({frame, inside})).empty());
    // What a region has taken away is not below the ground.
    BodyDescription raised = cube({0, -0.1, 0});
    raised.regions = {{{0, 0, 0}, {1, 0, 1}, -1}};
    CHECK(refusal(worldOf({raised})).empty());
    // Without contact bodies pass through each other; without position an object is nowhere.
    WorldDescription through = worldOf({cube({0, 0, 0}), cube({0, 0, 0})});
    CHECK(!refusal(through).empty());
    through.contact = false;
    CHECK(refusal(through).empty());
    WorldDescription thrown = worldOf({cube({0, 0, 0})}, {sphere({0, 0, 0})});
    thrown.objects[0].position.reset();
    thrown.throws = {{0, 0, {0, 0.1, 0}, {0, 0, 0}, {0, 0, 0}}};
    CHECK(refusal(thrown).empty());
}

TEST_CASE("turned bodies may touch in any way, but not be in each other") {
    const Mat3 turn = Eigen::AngleAxisd(0.5, Vec3(1, 3, 2).normalized()).toRotationMatrix();
    const auto turned = [&](BodyDescription body, const Mat3& by) {
        body.orientation = by;
        return body;
    };
    const auto moved = [&](BodyDescription body, const Vec3& by) {
        body.position += by;
        return body;
    };
    // Side by side, whatever their axes: 0.2 m wide, and about their bottom faces' centres.
    const BodyDescription one = turned(cube({0, 3, 0}), turn);
    for (const int axis : {0, 1, 2}) {
        CHECK(refusal(worldOf({one, moved(one, turn.col(axis) * 0.2)})).empty());
        // By 5 % of a cell, along that axis.
        const std::string text = refusal(worldOf({one, moved(one, turn.col(axis) * 0.195)}));
        CHECK_THAT(text, Catch::Contains("overlap by 0.005 m"));
    }
    // What is around them overlaps, and they do not.
    const Mat3 diagonal = Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitY()).toRotationMatrix();
    const BodyDescription corner = turned(cube({0, 3, 0}), diagonal);
    const double half = 0.1 * std::sqrt(2.);
    CHECK(refusal(worldOf({corner, cube({half + 0.1, 3, 0})})).empty());
    CHECK(refusal(worldOf({corner, cube({half + 0.09, 3, 0})})) != "");
    CHECK(refusal(worldOf({corner, turned(cube({0.15, 3, 0.15}), diagonal)})).empty());
    // Edge across edge: nothing but the cross product of the two tells them apart.
    BodyDescription ridge = cube({0, 3, 0}), across = cube({0, 3, 0});
    ridge.orientation = Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX());
    across.orientation = Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitZ());
    const auto centred = [](BodyDescription body, const Vec3& centre) {
        body.position = centre - body.orientation * Vec3(0, 0.1, 0);
        return body;
    };
    ridge = centred(ridge, {0, 3, 0});
    CHECK(refusal(worldOf({ridge, centred(across, {0, 3 + 2 * half + 1e-4, 0})})).empty());
    CHECK_THAT(refusal(worldOf({ridge, centred(across, {0, 3 + 2 * half - 0.02, 0})})),
               Catch::Contains("overlap by 0.02 m"));
    // The ground, and an object.
    BodyDescription lying = cube({0, 0.1, 0});
    lying.orientation = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX());
    WorldDescription ground = worldOf({lying});
    ground.ground = true;
    CHECK(refusal(ground).empty());
    ground.bodies[0].orientation = Eigen::AngleAxisd(2, Vec3::UnitX());
    CHECK_THAT(refusal(ground), Catch::Contains("below the ground"));
    CHECK(refusal(worldOf({corner}, {sphere({half + 0.101, 3.1, 0})})).empty());
    CHECK(refusal(worldOf({corner}, {sphere({half + 0.07, 3.1, 0})})) != "");
    CHECK(refusal(worldOf({corner}, {sphere({0.15, 3.1, 0.15})})).empty());
}

TEST_CASE("two turned bodies come apart along the axes of one of them") {
    const Mat3 turn = Eigen::AngleAxisd(0.8, Vec3(2, -1, 2) / 3).toRotationMatrix();
    BodyDescription a = cube({0, 3, 0}, 4), b = cube({0, 3, 0});
    a.mayOverlap = true;
    a.orientation = b.orientation = turn;
    b.position += turn * Vec3(0.25, 0.05, 0);
    const World world(worldOf({a, b}));
    REQUIRE(world.partings().size() == 1);
    const Parting& parting = world.partings()[0];
    // What the case below has, turned.
    CHECK((parting.way - turn * Vec3(-1, 0, 0)).norm() < 1e-12);
    CHECK((parting.low - Vec3(-0.05, -0.35, -0.3)).norm() < 1e-12);
    CHECK((parting.high - Vec3(0.55, 0.25, 0.3)).norm() < 1e-12);
    CHECK(parting.lasts({0, 0, 0}));
    CHECK(parting.lasts(turn * Vec3(-0.04, 0.2, 0)));
    CHECK(!parting.lasts(turn * Vec3(-0.06, 0, 0)));
    CHECK(!parting.lasts(turn * Vec3(0, 0.3, 0)));
}

TEST_CASE("one of two that is marked may be in the other, and has a way out") {
    BodyDescription a = cube({0, 0, 0}, 4), b = cube({0.25, 0.05, 0});
    for (const bool first : {true, false}) {
        (first ? a : b).mayOverlap = true;
        (first ? b : a).mayOverlap = false;
        const World world(worldOf({a, b, cube({5, 0, 0})}));
        REQUIRE(world.partings().size() == 1);
        const Parting& parting = world.partings()[0];
        CHECK(world.parting(1, 0) == &parting);
        CHECK(world.parting(0, 1) == &parting);
        CHECK(world.parting(0, 2) == nullptr);
        CHECK(parting.way == Vec3(-1, 0, 0));
        // 0.05 m to the left, 0.55 m to the right.
        CHECK((parting.low - Vec3(-0.05, -0.35, -0.3)).norm() < 1e-12);
        CHECK((parting.high - Vec3(0.55, 0.25, 0.3)).norm() < 1e-12);
        CHECK(parting.lasts({0, 0, 0}));
        CHECK(parting.lasts({-0.04, 0.2, 0}));
        CHECK(!parting.lasts({-0.06, 0, 0}));
        CHECK(!parting.lasts({0, 0.3, 0}));
    }
    // The deepest of the boxes that a body with holes is of says where to.
    a.regions = {{{1, 1, 0}, {2, 3, 3}, -1}};
    b.position = {0.01, 0.1, 0};
    const World world(worldOf({a, b}));
    REQUIRE(world.partings().size() == 1);
    CHECK(world.partings()[0].way == Vec3(1, 0, 0));
    CHECK(world.partings()[0].high[0] == Approx(0.01));
    // Objects, and what is below the ground, need none.
    WorldDescription d = worldOf({cube({0, -1, 0})}, {sphere({0, -1, 0}), sphere({0, -1, 0})});
    d.bodies[0].mayOverlap = d.objects[0].mayOverlap = d.objects[1].mayOverlap = true;
    CHECK(World(d).partings().empty());
    // A hostile file must not end in gigabytes.
    std::vector<BodyDescription> crowd(400, cube({0, 0, 0}, 1));
    for (BodyDescription& body : crowd) body.mayOverlap = true;
    checkParts(refusal(worldOf(crowd)), {"more than 65536 pairs of bodies overlap"});
}
