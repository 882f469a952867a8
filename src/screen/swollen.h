// Letters made thicker on every side, by the distance from their edge.
#pragma once

#include <cstdint>
#include <vector>

namespace screen {

// Shares of pixels that are covered, 0 to 255, row by row.
struct Bitmap {
    int width = 0, height = 0;
    std::vector<std::uint8_t> shares;
};

// How many pixels around its letter a bitmap must have to be swollen by `swell` pixels.
int swell_margin(double swell);

// What is within `swell` pixels (>= 0) of what is covered, its edge as soft as a pixel. Takes time in proportion to the
// pixels: the squared distance to the nearest covered one is the lower envelope of parabolas, along columns and
// then along rows (Felzenszwalb and Huttenlocher, "Distance transforms of sampled functions", 2012).
Bitmap swollen(Bitmap const& letter, double swell);

}  // namespace screen
