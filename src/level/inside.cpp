#include "level/inside.h"

#include <algorithm>
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

// Of the polygon of its curves' ends and middles.
double signed_area(Outline const& outline) {
    Vec2 const origin = geometry::start_of(outline.curves.front());
    double twice = 0;
    for (geometry::Curve const& curve : outline.curves) {
        Vec2 const from = geometry::start_of(curve) - origin, to = geometry::end_of(curve) - origin;
        Vec2 const middle = point_along(curve, 0.5) - origin;
        twice += geometry::cross(from, middle) + geometry::cross(middle, to);
    }
    return twice / 2;
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

bool fill_rules_differ(std::span<Outline const> outlines) {
    constexpr std::size_t most = 16;
    if (outlines.size() < 2 || outlines.size() > most) return false;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        Vec2 const start = geometry::start_of(outlines[i].curves.front());
        int const around = winding_round(outlines.first(i), start) + winding_round(outlines.subspan(i + 1), start);
        // Its own line is between what is around it and one turn more or less.
        int const within = around + (signed_area(outlines[i]) > 0 ? 1 : -1);
        if (std::abs(around) > 1 || std::abs(within) > 1) return true;
    }
    return false;
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
