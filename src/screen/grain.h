// The texture of the ground: soil with stones, in faint squares; repeats every few metres.
#pragma once

#include <cstdint>
#include <vector>

namespace screen {

constexpr int grain_side = 512;       // texels
constexpr double grain_metres = 6.4;  // that one side of the tile covers

// Brightness, 128 = leave the colour as it is; grain_side rows, tiles without a seam. The same every time.
std::vector<std::uint8_t> grain_tile();

// A square of the given side at half its size, each texel the mean of four.
std::vector<std::uint8_t> halved(std::vector<std::uint8_t> const& square, int side);

}  // namespace screen
