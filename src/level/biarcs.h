// Smooth curves as circular arcs that join with equal tangents: pairs of arcs, halved until they lie near enough.
#pragma once

#include <vector>

#include "geometry/curve.h"
#include "level/ellipse.h"

namespace level {

struct Cubic {
    Vec2 start = Vec2::Zero(), first = Vec2::Zero(), second = Vec2::Zero(), end = Vec2::Zero();
};

// End to start, from one end of the curve to the other, nowhere farther than `tolerance` (m, positive) from it. Where
// an arc would be flatter than `most_metres` it is a segment; so it is next to a cusp, which no arc can follow.
std::vector<geometry::Curve> arcs_of(Cubic const& cubic, double tolerance);
std::vector<geometry::Curve> arcs_of(EllipticalArc const& arc, double tolerance);

}  // namespace level
