// The numbers of the contact model.
#include "core/contact.hpp"

#include <numeric>

#include "catch.hpp"

using namespace sunder;
using namespace sunder::core;

TEST_CASE("a cell's spheres fill it, at most eight of them") {
    const auto check = [](const Vec3& size, const IVec3& count, double radius) {
        const ContactProxy proxy = contactProxy(size);
        CHECK(proxy.count == count);
        CHECK(proxy.radius == radius);
    };
    check({0.1, 0.1, 0.1}, {1, 1, 1}, 0.05);
    check({0.3, 0.8, 0.3}, {1, 3, 1}, 0.15);
    check({0.1, 0.2, 0.2}, {1, 2, 2}, 0.05);
    check({1, 1, 0.01}, {2, 3, 1}, 0.005);
    check({1e6, 1e-3, 1e-3}, {8, 1, 1}, 5e-4);
}

TEST_CASE("a sphere's weights are those of its place") {
    const ContactProxy proxy = contactProxy({0.1, 0.4, 0.2});
    REQUIRE(proxy.spheres() == 8);
    Vec3 mean = Vec3::Zero();
    for (int sphere = 0; sphere < 8; ++sphere) {
        Vec3 place = Vec3::Zero();
        double sum = 0;
        for (int corner = 0; corner < kCorners; ++corner) {
            const double weight = proxy.weights(sphere)[static_cast<std::size_t>(corner)];
            sum += weight;
            place += weight * Vec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        }
        // Products of three numbers below 1: a few roundings of 1.1e-16.
        CHECK(sum == Approx(1).epsilon(1e-15));
        CHECK((place - proxy.place(sphere)).norm() < 1e-15);
        mean += proxy.place(sphere) / 8;
    }
    CHECK((mean - Vec3(0.5, 0.5, 0.5)).norm() < 1e-15);
    CHECK(proxy.place(0) == Vec3(0.5, 0.125, 0.25));
}

TEST_CASE("damping falls as restitution rises") {
    CHECK(contactDamping(0) == kInelasticDamping);
    CHECK(contactDamping(1) < 1e-3);
    double before = kInelasticDamping;
    for (const double e : {0.2, 0.4, 0.6, 0.8, 0.95}) {
        CHECK(contactDamping(e) < before);
        before = contactDamping(e);
    }
}

TEST_CASE("spheres that meet within a step touch when their surfaces do") {
    const double h = 1e-3, radii = 0.1;
    // Head on: 0.05 m of gap at 100 m/s.
    CHECK(touchTime({0.15, 0, 0}, {-100, 0, 0}, radii, h) == Approx(5e-4));
    // Past each other by 0.06 m: they touch 0.08 m before the nearest point.
    CHECK(touchTime({0.15, 0.06, 0}, {-100, 0, 0}, radii, h) == Approx(7e-4));
    CHECK(touchTime({0.05, 0, 0}, {100, 0, 0}, radii, h) == 0);                    // they overlap
    for (const auto& [x, v] : {std::pair<Vec3, Vec3>{{0.25, 0, 0}, {-100, 0, 0}},  // too far
                               {{0.15, 0.11, 0}, {-100, 0, 0}},                    // they miss
                               {{0.15, 0, 0}, {100, 0, 0}},                        // they part
                               {{0.105, 0, 0}, {-9, 0, 0}},                        // slow enough
                               {{0.15, 0, 0}, {0, 0, 0}}})
        CHECK(touchTime(x, v, radii, h) > h);
    CHECK(closestApproach({0.15, 0.06, 0}, {-100, 0, 0}, 1) == Approx(0.06));
    CHECK(closestApproach({0.15, 0.08, 0}, {-100, 0, 0}, 9e-4) == Approx(0.1));
    CHECK(closestApproach({0.15, 0.08, 0}, {100, 0, 0}, 1) == Approx(0.17));
    CHECK(closestApproach({0.15, 0.08, 0}, {0, 0, 0}, 1) == Approx(0.17));
}
