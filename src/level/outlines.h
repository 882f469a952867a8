// From the drawing to the world: shapes under a transform as segments and arcs in metres.
#pragma once

#include <vector>

#include "level/level.h"
#include "level/shapes.h"
#include "level/transform.h"

namespace level {

struct Traced {
    std::vector<Outline> outlines;  // those that have a curve left
    int dropped = 0;                // pieces too short to be any
};

// Lines and circles stay what they are, and circular arcs under a similarity; every other curve becomes arcs within
// `tolerance` (m) of it that join with equal tangents. Throws TooFar where a coordinate or a radius is
// beyond the limit.
Traced traced(Shape const& shape, Affine const& to_world, double tolerance);

// A point in the world. Throws TooFar where it is beyond the limit.
Vec2 placed(Affine const& to_world, Vec2 const& point);

}  // namespace level
