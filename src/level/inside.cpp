#include "level/inside.h"

#include <cmath>

#include "geometry/elementary.h"

namespace level {

namespace {

double angle_between(Vec2 const& a, Vec2 const& b) { return std::atan2(geometry::cross(a, b), geometry::dot(a, b)); }

// The angle under which a point sees a curve go by.
double angle_swept(geometry::Curve const& curve, Vec2 const& point) {
    Vec2 const from = geometry::start_of(curve) - point, to = geometry::end_of(curve) - point;
    auto const* arc = std::get_if<geometry::Arc>(&curve);
    if (arc == nullptr) return angle_between(from, to);
    // Fine enough that the chords pass a point on its right side unless it lies within a thousandth of the radius.
    int const parts = 1 + static_cast<int>(std::abs(arc->sweep) * 16);
    double sum = 0;
    Vec2 before = from;
    for (int i = 1; i <= parts; ++i) {
        double const angle = arc->from + arc->sweep * i / parts;
        Vec2 const here = arc->centre + arc->radius * Vec2(std::cos(angle), std::sin(angle)) - point;
        sum += angle_between(before, here);
        before = here;
    }
    return sum;
}

bool holds(geometry::Box const& box, Vec2 const& point) { return geometry::overlap(box, {point, point}); }

}  // namespace

Vec2 point_along(geometry::Curve const& curve, double share) {
    if (auto const* segment = std::get_if<geometry::Segment>(&curve))
        return segment->start + share * (segment->end - segment->start);
    auto const& arc = std::get<geometry::Arc>(curve);
    geometry::SineCosine const turn = geometry::sine_cosine(arc.from + share * arc.sweep);
    return arc.centre + arc.radius * Vec2(turn.cosine, turn.sine);
}

geometry::Box box_of(std::span<Outline const> outlines) {
    geometry::Box box;
    for (Outline const& outline : outlines)
        for (geometry::Curve const& curve : outline.curves) box = geometry::united(box, geometry::box_of(curve));
    return box;
}

int winding_round(std::span<Outline const> outlines, Vec2 const& point) {
    double sum = 0;
    for (Outline const& outline : outlines) {
        if (!outline.closed || !holds(box_of(std::span(&outline, 1)), point)) continue;
        for (geometry::Curve const& curve : outline.curves) sum += angle_swept(curve, point);
    }
    return static_cast<int>(std::lround(sum / (2 * geometry::pi)));
}

}  // namespace level
