// How much of each pixel lies inside closed polylines: exact areas, even-odd, no GL.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vector.h"

namespace screen {

// A box of pixels, 255 where all of the pixel is inside; the top row first.
struct Coverage {
    int left = 0, top = 0, width = 0, height = 0;  // pixels; no area when nothing is inside
    std::vector<std::uint8_t> values;
};

// Of the pixels of a frame of the given size. Where edges cross inside one pixel its value is approximate.
Coverage even_odd_coverage(std::vector<std::vector<geometry::Vec2>> const& rings, int frame_width, int frame_height);

}  // namespace screen
