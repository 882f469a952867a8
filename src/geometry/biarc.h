// Drawn curves as arcs that join with equal tangents: Bezier curves and ellipses (physics.md 10.1).
#pragma once

#include <vector>

#include "geometry/curve.h"

namespace geometry {

inline constexpr double drawing_tolerance = 1e-3;  // m, how far an arc may leave the curve it stands for

// Each answer runs from the first point to the last, end to start; it is empty where the curve is a single point.
// Tangents agree at the joints except at the cusps of the curve itself, and to 1e-3 rad where the curve is flatter than
// a circle of 1e6 m: there its arcs are straight lines.
std::vector<Curve> arcs_of_cubic(Vec2 const& p0, Vec2 const& p1, Vec2 const& p2, Vec2 const& p3,
                                 double tolerance = drawing_tolerance);

// centre + first cos(t) + second sin(t) for t from `from` over `sweep`. An affine map acts on the centre and on both
// axes.
struct EllipticArc {
    Vec2 centre = Vec2::Zero();
    Vec2 first = Vec2::Zero();
    Vec2 second = Vec2::Zero();
    double from = 0;   // rad
    double sweep = 0;  // rad, at most one whole turn either way
};

// A circle gives one exact arc.
std::vector<Curve> arcs_of_ellipse(EllipticArc const& ellipse, double tolerance = drawing_tolerance);

}  // namespace geometry
