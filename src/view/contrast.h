// High contrast: what is written stands on solid plates, in black or white; what the ball meets and what counts has
// outlines, and patterns where colour alone would tell two things apart.
#pragma once

#include <vector>

#include "level/level.h"
#include "view/camera.h"
#include "view/moment.h"
#include "view/picture.h"

namespace view {

enum class Contrast { usual, high };

// The ratio of the luminances of two colours, 1 to 21 (WCAG 2.1), as if both were opaque.
double contrast_ratio(Colour const& a, Colour const& b);

// Of letters: they become black or white, or are deepened as far as it takes, where the colour joins them to a thing.
enum class Hue { dropped, kept };

// The same shapes with plates that hide what is behind them, rimmed, and letters on them in what of black and white is
// farther from the plate, or in their own hue. What is more than half faded stays as it is.
std::vector<Shape> in_high_contrast(std::vector<Shape> shapes, Hue hue = Hue::dropped);

// Every curve that balls meet, in black and white, with signs of what it is: notches across grip, slanting pairs on
// ice, dots in mud, a zigzag where it throws back.
std::vector<Shape> terrain_outlines(physics::Terrain const& terrain, Camera const& camera);

// Rings round balls, the player's the strongest, and round bananas that are still there; the goal's edge.
std::vector<Shape> actor_outlines(level::Level const& level, Moment const& moment, Camera const& camera);

// Discs as short strokes: another pattern for what else were told from dots by its colour.
std::vector<Shape> dashed(std::vector<Shape> shapes);

}  // namespace view
