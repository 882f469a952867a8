// CSS colours.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace level {

struct Colour {
    double red = 0, green = 0, blue = 0, opacity = 1;  // each from 0 to 1
};

// Of #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(), rgba(), hsl(), hsla() and the names of CSS; nothing for none and
// transparent. Throws Unsupported for what is none of these, gradients for one.
std::optional<Colour> colour_in(std::string_view text);

std::string hexadecimal_of(Colour const& colour);  // "#rrggbb"

}  // namespace level
