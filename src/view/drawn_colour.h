// Colours as the drawing gives them.
#pragma once

#include <cstdlib>
#include <string>

#include "view/palette.h"

namespace view {

// Of #rrggbb.
inline Colour drawn_colour(std::string const& text) {
    return colour(static_cast<std::uint32_t>(std::strtoul(text.c_str() + 1, nullptr, 16)));
}

}  // namespace view
