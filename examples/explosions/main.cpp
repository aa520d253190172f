// A hundred explosions in one frame among twenty walls, on the CPU: prints what a frame costs
// before, in and after it.
#include <sunder/sunder.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

namespace {

double milliseconds(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

}  // namespace

int main() {
    sunder::WorldDesc desc;
    const int concrete = desc.addMaterial(sunder::Material::preset("concrete"));
    for (int i = 0; i < 20; ++i)
        desc.addBody({.material = concrete,
                      .size = {2, 1.5, 0.2},
                      .cells = {16, 12, 2},
                      .position = {3.0 * (i % 5), 0, 3.0 * (i / 5)},
                      .anchors = sunder::Side::Bottom});
    auto made = sunder::World::create(desc);
    if (!made) {
        std::fprintf(stderr, "explosions: %s\n", made.error().message.c_str());
        return 1;
    }
    sunder::World& world = *made;

    std::vector<double> before, after;
    double during = 0;
    for (int frame = 0; frame < 40; ++frame) {
        const double taken = milliseconds([&] {
            if (frame == 20)
                for (int i = 0; i < 100; ++i)
                    world.push({.at = {0.15 * i - 1, 0.5 + 0.01 * i, 3.0 * (i % 4)},
                                .radius = 0.6,
                                .outward = 12,
                                .falloff = true});
            world.step(1.0 / 60);
        });
        if (frame == 20)
            during = taken;
        else
            (frame < 20 ? before : after).push_back(taken);
    }
    const auto median = [](std::vector<double>& values) {
        std::nth_element(values.begin(),
                         values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                         values.end());
        return values[values.size() / 2];
    };
    const auto broken = world.brokenBonds();
    if (!broken) return 1;
    std::printf(
        "a frame: %.2f ms before, %.2f ms with a hundred explosions, %.2f ms after; %d bonds "
        "broke\n",
        median(before), during, median(after), *broken);
    return *broken > 0 ? 0 : 1;
}
