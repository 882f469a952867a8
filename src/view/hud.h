// What is written over the scene: clock, bananas, messages, help, the level that shows the tilt.
#pragma once

#include <string>
#include <vector>

#include "level/level.h"
#include "view/camera.h"
#include "view/moment.h"
#include "view/picture.h"

namespace view {

// The pixels that a pixel of a picture of 1280x720 becomes.
double hud_scale(Vec2 const& size);

std::vector<Shape> heading_shapes(level::Level const& level, Moment const& moment, Vec2 const& size);

// A spirit level, shown while gravity is turned: its bubble is where the stage is high.
std::vector<Shape> tilt_shapes(level::Level const& level, double tilt, Vec2 const& size);

struct KeyHelp {
    std::vector<std::string> keys;
    std::string meaning;
};
// In two columns, from the top down.
std::vector<Shape> help_shapes(std::string const& title, std::vector<KeyHelp> const& rows, Vec2 const& size);

// A line at the lower edge, or `lift` pixels higher; presence fades it, 1 to 0.
std::vector<Shape> toast_shapes(std::string const& text, double presence, Vec2 const& size, double lift = 0);

// By how much a toast is lifted, pixels, to stand above the page of help.
double lift_over_help(Vec2 const& size);

// A word in the upper middle: paused, slow motion.
std::vector<Shape> badge_shapes(std::string const& text, Vec2 const& size);

// What stands for bananas and for pulls, `size` high, pixels.
void add_banana_mark(std::vector<Shape>& shapes, Vec2 const& at, double size);
void add_spring_mark(std::vector<Shape>& shapes, Vec2 const& at, double size);

// A number with so many digits after the point.
std::string written(double value, int digits);

// Roughly how wide a line of text is, in units of its height: for panels behind text.
double text_width(std::string const& text);

}  // namespace view
