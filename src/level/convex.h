// Polygons in convex parts.
#pragma once

#include <vector>

#include "geometry/vector.h"

namespace level {

using geometry::Vec2;

// Without corners that repeat the one before or lie on the straight way between their neighbours.
std::vector<Vec2> without_needless(std::vector<Vec2> const& corners);

// Counter-clockwise convex polygons that make up the one with these corners, in either sense: itself where it is
// convex. Empty where its edges cross or touch. By clipping ears and joining triangles while they stay convex (Hertel
// and Mehlhorn, 1983), at most four times as many parts as need be.
std::vector<std::vector<Vec2>> convex_parts(std::vector<Vec2> corners);

}  // namespace level
