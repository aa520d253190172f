#include "render/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "image/srgb.hpp"

namespace sunder::render {
namespace {

/// Every eighth of viridis (S. van der Walt, N. Smith and E. Firing for matplotlib, CC0), sRGB.
constexpr glm::vec3 kViridis[] = {{0x44, 0x01, 0x54}, {0x47, 0x2c, 0x7a}, {0x3b, 0x52, 0x8b},
                                  {0x2c, 0x72, 0x8e}, {0x21, 0x91, 0x8c}, {0x28, 0xae, 0x80},
                                  {0x5e, 0xc9, 0x62}, {0xaa, 0xdc, 0x32}, {0xfd, 0xe7, 0x25}};

/// B. Ottosson's Oklab (2020): lightness and two opponent colours, to linear RGB.
glm::vec3 fromOklab(float lightness, float a, float b) {
    const glm::vec3 root(lightness + 0.3963377774f * a + 0.2158037573f * b,
                         lightness - 0.1055613458f * a - 0.0638541728f * b,
                         lightness - 0.0894841775f * a - 1.2914855480f * b);
    const glm::vec3 cones = root * root * root;
    return {glm::dot(cones, glm::vec3(4.0767416621f, -3.3077115913f, 0.2309699292f)),
            glm::dot(cones, glm::vec3(-1.2684380046f, 2.6097574011f, -0.3413193965f)),
            glm::dot(cones, glm::vec3(-0.0041960863f, -0.7034186147f, 1.7076147010f))};
}

}  // namespace

glm::vec3 mapColour(double value) {
    constexpr int kLast = static_cast<int>(std::size(kViridis)) - 1;
    const double place = value > 0 ? std::min(value, 1.0) * kLast : 0;
    const int below = std::min(static_cast<int>(place), kLast - 1);
    const glm::vec3 srgb =
        glm::mix(kViridis[below], kViridis[below + 1], static_cast<float>(place - below)) / 255.f;
    return {image::linearFromSrgb(srgb.r), image::linearFromSrgb(srgb.g),
            image::linearFromSrgb(srgb.b)};
}

glm::vec3 distinctColour(int number) {
    // Roberts's R2 sequence: the first n of its points are far apart in hue and lightness for any
    // n.
    const double hue = std::fmod(0.7548776662466927 * number, 1);
    const double lightness = 0.58 + 0.27 * std::fmod(0.5698402909980532 * number, 1);
    constexpr double kChroma = 0.13, kTurn = 6.283185307179586;
    const glm::vec3 colour = fromOklab(static_cast<float>(lightness),
                                       static_cast<float>(kChroma * std::cos(kTurn * hue)),
                                       static_cast<float>(kChroma * std::sin(kTurn * hue)));
    return glm::clamp(colour, 0.f, 1.f);
}

}  // namespace sunder::render
