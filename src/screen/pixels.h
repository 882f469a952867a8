// Pixels in memory: the plain result of painting, on its way to a file, an encoder or a window.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace screen {

// Four bytes a pixel (red, green, blue, alpha; alpha is 255 everywhere), the top row first, no padding.
struct Pixels {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

// The longest side of a picture: what every OpenGL 3.3 renderer we met can hold as a texture.
constexpr int longest_side = 8192;

// Throws std::runtime_error that names the size unless both sides are 1 to longest_side.
void require_paintable(int width, int height);

}  // namespace screen
