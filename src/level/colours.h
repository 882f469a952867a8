// CSS colours.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace level {

// As #rrggbb: of #rgb, #rrggbb, rgb() with numbers or per cent, and the names of CSS; nothing for none and transparent.
// Throws Unsupported for what is none of these, gradients for one.
std::optional<std::string> colour_in(std::string_view text);

}  // namespace level
