#pragma once
#include "image/image.hpp"

/// In pixels of a picture, from its top left.
struct Area {
    int left, top, width, height;
};

constexpr int kPanel = 340;  ///< width of the panel at scale 1, pixels

/// All beside the panel but the lowest rows, where a hint may be.
Area sceneOf(const sunder::image::Image&);

/// Share of an area's pixels that differ by more than a little.
double difference(const sunder::image::Image&, const sunder::image::Image&, const Area&);
double sceneDifference(const sunder::image::Image&, const sunder::image::Image&);
/// Share of an area's pixels of about this colour.
double share(const sunder::image::Image&, const Area&, int red, int green, int blue);
/// How many clearly different colours an area has, at most 4096.
int colours(const sunder::image::Image&, const Area&);

/// The panel is there, with its coloured headings, and the scene beside it is no plain area.
void checkLooksRight(const sunder::image::Image&, int panel = kPanel);
