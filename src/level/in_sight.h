// What nested svg elements leave in sight: convex parts of the world, and what lies in them.
#pragma once

#include <span>
#include <vector>

#include "level/level.h"
#include "level/transform.h"

namespace level {

using Sight = std::vector<Vec2>;  // m, corners counter-clockwise; none where nothing is in sight

// A rect under a map.
Sight sight_of(geometry::Box const& rect, Affine const& to_world);

// By Sutherland and Hodgman, 1974. `a` alone where that would have more than 64 corners.
Sight common_part(Sight const& a, Sight const& b);

// To a micrometre. Arcs are asked at 33 points.
bool holds(Sight const& sight, std::span<Outline const> outlines);

}  // namespace level
