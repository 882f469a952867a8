// What is worth knowing of a sound level: its scale, and whether it can be won.
#pragma once

#include <string>
#include <vector>

#include "level/level.h"

namespace level {

inline constexpr double widest_ball = 2;        // m across: more than that, and the drawing was hardly meant in metres
inline constexpr double narrowest_ball = 0.05;  // m across

std::vector<std::string> notes_on(Level const& level);

}  // namespace level
