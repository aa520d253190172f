#include "app/start.hpp"

#include <iostream>

#include "app/progress.hpp"
#include "cpu/settle.hpp"

namespace sunder::app {

State startOf(const Scene& scene, const World& world) {
    constexpr int kParts = 1000;
    Start start;
    {
        Progress progress(scene.name + ", coming to rest", kParts);
        start = settledStart(
            world, [&](double share) { progress.update(static_cast<int>(kParts * share)); });
    }
    if (const std::string warning = restlessWarning(start); !warning.empty())
        std::cerr << "sunder: note: " << warning << '\n';
    return std::move(start.state);
}

}  // namespace sunder::app
