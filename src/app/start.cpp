#include "app/start.hpp"

#include <iostream>

#include "app/progress.hpp"
#include "cpu/settle.hpp"

namespace sunder::app {

using namespace core;

State startOf(const scene::Scene& scene, const World& world) {
    constexpr int kParts = 1000;
    cpu::Start start;
    {
        Progress progress(scene.name + ", coming to rest", kParts);
        start = cpu::settledStart(
            world, [&](double share) { progress.update(static_cast<int>(kParts * share)); });
    }
    if (const std::string warning = cpu::restlessWarning(start); !warning.empty())
        std::cerr << "sunder: note: " << warning << '\n';
    return std::move(start.state);
}

}  // namespace sunder::app
