// Threads that meet at every pass: whoever comes, each item is worked on once, and nobody waits for
// one who does not come.
#include "cpu/crew.hpp"

#include <numeric>
#include <stdexcept>
#include <string>

#include "catch.hpp"
#include "cpu/team.hpp"

using namespace sunder;

namespace {

/// A host that runs its tasks on fewer threads than it says, the last task first.
struct Host {
    int threads;
    TaskSystem tasks{this, [](void*) { return 8; }, forEach};

    static void forEach(void* user, int count, void (*task)(void*, int), void* data) {
        std::atomic<int> left{count};
        const auto take = [&] {
            for (int i = --left; i >= 0; i = --left) task(data, i);
        };
        std::vector<std::thread> others;
        for (int i = 1; i < static_cast<Host*>(user)->threads; ++i) others.emplace_back(take);
        take();
        for (std::thread& other : others) other.join();
    }
};

/// Adds up, pass by pass, where every item reads what others wrote in the pass before.
std::vector<long> sums(cpu::Team& team, int passes) {
    constexpr int kItems = 37;
    std::vector<long> now(kItems, 1), next(kItems);
    team.run([&] {
        for (int pass = 0; pass < passes; ++pass) {
            const int items = pass % 3 == 0 ? 5 : kItems;
            team.forEach(items, [&](int i) { next[i] += now[(i + 11) % kItems] % 1000 + i; });
            std::swap(now, next);
        }
    });
    return now;
}

}  // namespace

TEST_CASE("a crew works each item of each pass once, whoever comes") {
    cpu::Team alone{cpu::Threads(1)};
    const std::vector<long> expected = sums(alone, 500);
    for (const int threads : {2, 5}) {
        INFO(threads << " threads");
        cpu::Team team{cpu::Threads(threads)};
        CHECK(sums(team, 500) == expected);
        CHECK(sums(team, 500) == expected);
    }
    for (const int threads : {1, 2, 8, 11}) {
        INFO("a host's " << threads << " threads of 8");
        Host host{threads};
        cpu::Team team{cpu::Threads(&host.tasks)};
        CHECK(sums(team, 500) == expected);
    }
}

TEST_CASE("what a crew's work throws reaches the caller, and the crew goes on") {
    Host host{3};
    cpu::Team onHost{cpu::Threads(&host.tasks)}, own{cpu::Threads(4)};
    for (cpu::Team* team : {&onHost, &own}) {
        const auto throwing = [](int i) {
            if (i == 3) throw std::runtime_error("three");
        };
        CHECK_THROWS_WITH(team->run([&] { team->forEach(9, throwing); }), "three");
        std::atomic<int> count{0};
        team->run([&] { team->forEach(9, [&](int) { ++count; }); });
        CHECK(count == 9);
    }
}
