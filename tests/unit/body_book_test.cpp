// Which bodies are there, held and asleep: core/body_book.hpp.
#include "core/body_book.hpp"

#include "catch.hpp"
#include "support/object_worlds.hpp"
#include "support/worlds.hpp"

using namespace sunder::core;

namespace {

/// Three blocks in a row along x, each 0.2 m wide, at these places, and a ball on the first.
World threeBlocks(double second, double third) {
    WorldDescription d = block({2, 2, 2}, softElastic());
    for (const double x : {second, third}) {
        d.bodies.push_back(d.bodies[0]);
        d.bodies.back().position = {x, 0, 0};
    }
    d.contact = true;
    d.objects = {ball(0.1, 1, {0, 0.3, 0}, {0, 0, 0})};
    return World(std::move(d));
}

using Bodies = std::vector<int>;
using Status = RestIslands::Status;

/// Boxes of those that `wanted` chooses, as at rest and 1 mm larger.
BodyBook::AddBoxes boxesOf(const World& world, const std::function<bool(int)>& wanted) {
    return [&world, wanted](std::vector<RestBox>& boxes) {
        for (int body = 0; body < static_cast<int>(world.bodies().size()); ++body) {
            const Box box = world.bodies()[body].bounds();
            const Vec3 reach = Vec3::Constant(1e-3);
            if (wanted(body))
                boxes.push_back({memberOfBody(body), box.low - reach, box.high + reach});
        }
    };
}

}  // namespace

TEST_CASE("Body book: what is absent or elsewhere is not active, and never sleeps") {
    const World world = threeBlocks(0.2, 0.4);
    BodyBook book(world);
    CHECK(book.activeBodies() == Bodies{0, 1, 2});
    CHECK(book.absent().empty());
    book.setPresent(0, false);
    book.setHeld(1, false);
    CHECK(book.absent() == Bodies{0});
    CHECK(book.activeBodies() == Bodies{2});
    CHECK((book.holds(0) && !book.active(0) && book.present(1) && !book.active(1)));
    const auto active = boxesOf(world, [&](int body) { return book.active(body); });
    const auto fell =
        book.settle([](int) { return true; }, active, [](int) { return Status::Restless; },
                    world.initialState().objects);
    CHECK(fell.bodies == Bodies{2});
    CHECK((!book.asleep(0) && !book.asleep(1) && book.asleep(2)));
    CHECK(book.awakeBodies().empty());

    for (const int body : {0, 1, 2}) book.setHeld(body, false);
    CHECK(!book.holdsAny());
    State state;
    state.absent = {1};
    book.follow(state);
    CHECK(book.absent() == Bodies{1});
}

TEST_CASE("Body book: what touches sleeps and wakes together, and around what comes or goes") {
    // The first two touch, and the ball lies on the first; the third stands apart.
    const World world = threeBlocks(0.2, 2);
    const std::vector<ObjectState> objects = world.initialState().objects;
    BodyBook book(world);
    const auto every = boxesOf(world, [](int) { return true; });
    const auto settle = [&](const std::function<bool(int)>& ready) {
        return book.settle(
            ready, every, [](int) { return Status::Ready; }, objects);
    };
    // Where one of an island is restless, the others wait for it.
    const auto first = settle([](int body) { return body != 1; });
    CHECK((first.bodies == Bodies{2} && first.objects.empty()));
    const auto second = settle([](int) { return true; });
    CHECK((second.bodies == Bodies{0, 1} && second.objects == Bodies{0}));
    CHECK(book.objectAsleep(0));

    const auto woken = book.wake(memberOfObject(world, 0));
    CHECK((woken.bodies == Bodies{0, 1} && woken.objects == Bodies{0}));
    CHECK((book.awake(0) && book.asleep(2) && !book.objectAsleep(0)));
    CHECK(book.wake(memberOfBody(0)).bodies.empty());

    settle([](int) { return true; });
    const auto asleep = boxesOf(world, [&](int body) { return book.asleep(body); });
    std::vector<RestBox> own;
    boxesOf(world, [](int body) { return body == 2; })(own);
    CHECK(book.wakeAround(2, own, asleep, objects).bodies == Bodies{2});
    own.clear();
    boxesOf(world, [](int body) { return body == 1; })(own);
    const auto around = book.wakeAround(1, own, asleep, objects);
    CHECK((around.bodies == Bodies{0, 1} && around.objects == Bodies{0}));
}
