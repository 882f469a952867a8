// How much of each pixel lies inside closed polylines: exact areas, no GL.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/fill_rule.h"
#include "geometry/vector.h"

namespace screen {

// Areas are painted in squares of pixels: those all inside need no coverage, those all outside no paint.
constexpr int tile_side = 16;  // pixels

struct Box {
    int left = 0, top = 0, right = 0, bottom = 0;  // pixels, right and bottom excluded
};

// A square that an edge runs through: 255 where all of the pixel is inside; the top row first.
struct EdgeTile {
    int left = 0, top = 0;  // pixels
    std::array<std::uint8_t, tile_side * tile_side> values{};
};

// What of the tile is not empty, pixels of the frame, outwards to blocks of 4 by 4: renderers on the processor shade
// such blocks whole.
Box seen_part_of(EdgeTile const& tile);

// Tiles lie at multiples of tile_side and may reach beyond the frame by less than one.
struct Coverage {
    std::vector<Box> inside;
    std::vector<EdgeTile> edges;
};

// Of the pixels of a frame of the given size. Where edges cross inside one pixel its value is approximate.
Coverage coverage_of(std::vector<std::vector<geometry::Vec2>> const& rings, geometry::FillRule rule, int frame_width,
                     int frame_height);

}  // namespace screen
