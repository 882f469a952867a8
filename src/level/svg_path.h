// SVG path data as subpaths of straight lines, elliptical arcs and Bezier curves, in the drawing's own units.
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "geometry/vector.h"

namespace level {

using geometry::Vec2;

struct LineTo {
    Vec2 end = Vec2::Zero();
};
struct ArcTo {
    double rx = 0, ry = 0;  // positive
    double rotation = 0;    // degrees, of the x axis
    bool large = false, sweep = false;
    Vec2 end = Vec2::Zero();
};
struct QuadraticTo {
    Vec2 control = Vec2::Zero(), end = Vec2::Zero();
};
struct CubicTo {
    Vec2 first = Vec2::Zero(), second = Vec2::Zero(), end = Vec2::Zero();
};
using Draw = std::variant<LineTo, ArcTo, QuadraticTo, CubicTo>;

Vec2 end_of(Draw const& draw);

struct Subpath {
    Vec2 start = Vec2::Zero();
    std::vector<Draw> draws;  // each from the end of the one before; none: a point that is closed, "M 1 1 Z"
    bool closed = false;      // the way back to the start is among the draws
};

// Throws Broken where the data does not follow the grammar.
std::vector<Subpath> parsed_path(std::string_view data);

// The same from the points of a polyline or, closed, a polygon.
std::vector<Subpath> parsed_points(std::string_view points);
Subpath closed_to_start(Subpath subpath);

}  // namespace level
