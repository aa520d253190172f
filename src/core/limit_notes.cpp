#include "core/limit_notes.hpp"

#include <cmath>
#include <cstdio>

namespace sunder::core {

namespace {

std::string threeDigits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

/// Two digits are enough from ten on.
std::string times(double factor) {
    if (factor < 9.95) return threeDigits(factor);
    const double unit = std::pow(10, std::floor(std::log10(factor)) - 1);
    char text[32];
    std::snprintf(text, sizeof text, "%.0f", unit * std::round(factor / unit));
    return text;
}

}  // namespace

std::vector<std::string> limitNotes(const World& world) {
    std::vector<std::string> notes;
    const double substeps = 1 / (60 * world.step());
    for (const ElementLaw& law : world.laws()) {
        if (!law.limited) continue;
        const Material& material = world.description().materials[law.material];
        notes.push_back(material.name + ": E " + threeDigits(material.youngModulus) +
                        " limited to " + threeDigits(law.youngModulus) + " Pa at " +
                        std::to_string(std::lround(substeps)) + " substeps per 1/60 s: it sags " +
                        times(material.youngModulus / law.youngModulus) + " times as far");
    }
    return notes;
}

}  // namespace sunder::core
