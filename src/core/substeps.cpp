#include "core/substeps.hpp"

#include <algorithm>
#include <cmath>

#include "core/elasticity.hpp"
#include "core/world.hpp"

namespace sunder::core {

int substepsFor(const WorldDescription& world, int most) {
    double wanted = kFewestSubsteps;
    const auto carry = [&](int index, double edge) {
        const Material& m = world.materials[index];
        // E of what a step carries goes with its square.
        const double stable = stableYoungModulus(m.density, edge, m.poissonRatio, 1.0 / 60);
        wanted = std::max(wanted, std::sqrt(m.youngModulus / stable));
    };
    for (const BodyDescription& body : world.bodies) {
        const double edge = body.size.cwiseQuotient(body.cells.cast<double>()).minCoeff();
        carry(body.material, edge);
        for (const RegionDescription& region : body.regions)
            if (region.material >= 0) carry(region.material, edge);
    }
    if (wanted <= kFewestSubsteps) return std::min(kFewestSubsteps, most);
    // Rounding must not leave a material limited by its last digit.
    constexpr double rounding = 1 + 1e-12;
    const double looks = std::ceil(wanted * rounding / kLookSteps);
    return static_cast<int>(std::min<double>(kLookSteps * looks, most));
}

}  // namespace sunder::core
