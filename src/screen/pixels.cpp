#include "screen/pixels.h"

#include <stdexcept>

namespace screen {

void require_paintable(int width, int height) {
    if (width >= 1 && height >= 1 && width <= longest_side && height <= longest_side) return;
    throw std::runtime_error("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                             " cannot be painted: each side must be 1 to " + std::to_string(longest_side));
}

}  // namespace screen
