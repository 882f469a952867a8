// The texture of the ground: soil with stones, in faint squares; repeats every few metres.
#pragma once

#include <cstdint>
#include <vector>

namespace screen {

constexpr int grain_side = 512;       // texels
constexpr double grain_metres = 6.4;  // that one side of the tile covers

// Brightness, 128 = leave the colour as it is; grain_side rows, tiles without a seam. The same every time.
std::vector<std::uint8_t> grain_tile();

}  // namespace screen
