// Which side of a closed outline a point lies on.
#pragma once

#include <span>

#include "level/level.h"

namespace level {

// How often the closed ones among the outlines go round the point, counter-clockwise positive; as SVG's nonzero rule
// has it. The point must not lie on an outline.
int winding_round(std::span<Outline const> outlines, Vec2 const& point);

// The point after a share of the curve, from 0 to 1.
Vec2 point_along(geometry::Curve const& curve, double share);

geometry::Box box_of(std::span<Outline const> outlines);

}  // namespace level
