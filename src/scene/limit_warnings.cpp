#include "scene/limit_warnings.hpp"

#include <cstdio>

namespace sunder {
namespace {

std::string threeDigits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

}  // namespace

std::vector<std::string> limitWarnings(const Scene& scene, const World& world) {
    std::vector<std::string> warnings;
    for (const ElementLaw& law : world.laws()) {
        if (!law.limited) continue;
        const Material& material = world.description().materials[law.material];
        warnings.push_back(material.name + ": E " + threeDigits(material.youngModulus) +
                           " limited to " + threeDigits(law.youngModulus) + " Pa at " +
                           std::to_string(scene.substeps) + " substeps per 1/60 s");
    }
    return warnings;
}

}  // namespace sunder
