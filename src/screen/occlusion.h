// Which squares of a frame are painted over whole by something later: what lies below need not be painted, and no byte
// of the picture changes. No GL here.
#pragma once

#include <vector>

#include "screen/coverage.h"

namespace screen {

// Shapes are numbered in the order of painting; squares are the tiles of coverage.h.
class Occlusion {
public:
    Occlusion(int width, int height);

    // An opaque shape paints all of the box, whose edges lie at multiples of tile_side.
    void cover(Box const& box, int shape);

    // Whether all of the box, pixels, is painted over after the shape; not where it is out of the frame.
    bool hides(Box const& box, int shape) const;

    // What of a box, whose edges lie at multiples of tile_side, is not painted over after the shape.
    std::vector<Box> seen(Box const& box, int shape) const;

private:
    int last(int column, int row) const { return last_[static_cast<std::size_t>(row * columns_ + column)]; }

    int columns_, rows_;
    std::vector<int> last_;  // by square: the last shape that covers it, -1 none
};

}  // namespace screen
