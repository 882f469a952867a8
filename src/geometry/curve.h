// What terrain is made of: straight segments and circular arcs, and the questions one may ask of both.
#pragma once

#include <variant>

#include "geometry/vector.h"

namespace geometry {

struct Segment {
    Vec2 start = Vec2::Zero();  // m
    Vec2 end = Vec2::Zero();    // m
};

struct Arc {
    Vec2 centre = Vec2::Zero();  // m
    double radius = 0;           // m
    double from = 0;             // rad, angle of the start seen from the centre
    double sweep = 0;            // rad, counter-clockwise positive, |sweep| <= 2 pi; 2 pi is a whole circle
};

using Curve = std::variant<Segment, Arc>;

Vec2 start_of(Curve const& curve);
Vec2 end_of(Curve const& curve);
double length_of(Curve const& curve);

// Unit tangents in the sense of travel from start to end.
Vec2 tangent_at_start(Curve const& curve);
Vec2 tangent_at_end(Curve const& curve);

// The same points, travelled the other way.
Curve reversed(Curve const& curve);

// Whether the curve is an arc that goes all the way round.
bool is_whole_circle(Curve const& curve);

// Whether `angle` lies within the arc's sweep, the ends included.
bool spans(Arc const& arc, double angle);

struct Nearest {
    Vec2 point = Vec2::Zero();
    double distance = 0;  // m
    bool inside = false;  // the foot is between the ends, not at one of them
};
Nearest nearest_point(Curve const& curve, Vec2 const& from);

struct Box {
    Vec2 low = Vec2::Constant(1e300);
    Vec2 high = Vec2::Constant(-1e300);
};
Box box_of(Curve const& curve);
Box united(Box const& a, Box const& b);
Box grown(Box const& box, double margin);

// How far a curve reaches along a unit vector.
struct Extent {
    double low = 1e300;
    double high = -1e300;
};
Extent extent_along(Curve const& curve, Vec2 const& direction);
inline bool overlap(Box const& a, Box const& b) {
    return a.low.x() <= b.high.x() && b.low.x() <= a.high.x() && a.low.y() <= b.high.y() && b.low.y() <= a.high.y();
}

}  // namespace geometry
