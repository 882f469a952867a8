// Small pictures that the tests of the screen share.
#pragma once

#include <filesystem>

#include "screen/pixels.h"
#include "view/picture.h"

namespace samples {

using view::Vec2;

constexpr view::Colour black{0, 0, 0, 1}, white{1, 1, 1, 1}, red{1, 0, 0, 1}, blue{0, 0, 1, 1};

view::Area area(std::vector<std::vector<Vec2>> const& rings, view::Colour const& colour);

// Nothing but the colour.
view::Picture plain(int width, int height, view::Colour const& colour);

view::Picture shapes();  // discs, strokes, arcs, panels
view::Picture ground();  // areas with a hole, grain, shadow, lit edge
view::Picture balls();   // shells of several sizes, angles and liveries
view::Picture letters();

// By one painter for all that ask nothing of it: to make one takes longer than to paint. For one thread.
screen::Pixels painted(view::Picture const& picture);

struct Rgb {
    int red = 0, green = 0, blue = 0;
    bool operator==(Rgb const&) const = default;
};
Rgb at(screen::Pixels const& pixels, int x, int y);

screen::Pixels read_png(std::filesystem::path const& file);

}  // namespace samples
