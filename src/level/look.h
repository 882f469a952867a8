// How a shape of the drawing is painted.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "level/paints.h"
#include "level/level.h"
#include "level/style.h"

namespace level {

// The filled and the stroked part of a shape, at most one of each. Throws Unsupported for paint or a width of stroke
// that this program does not know.
std::vector<Decoration> decorations_of(std::vector<Outline> const& outlines, Style const& style, Affine const& to_world,
                                       Paints& paints);

// The plain colours that a style gives; what it leaves open, or paints otherwise, is left to the program.
Tint tint_of(Style const& style, Paints& paints);

}  // namespace level
