#include "geometry/curve.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "geometry/match.h"

namespace geometry {

namespace {

constexpr double angle_rounding = 1e-12;  // rad, an angle this far beyond an end is the end itself

Vec2 direction(double angle) {
    SineCosine const turn = sine_cosine(angle);
    return {turn.cosine, turn.sine};
}

Vec2 point_at(Arc const& arc, double angle) { return arc.centre + arc.radius * direction(angle); }

Vec2 tangent_at(Arc const& arc, double angle) {
    return arc.sweep < 0 ? turned_right(direction(angle)) : turned_left(direction(angle));
}

Vec2 tangent_of(Segment const& segment) {
    Vec2 const along = segment.end - segment.start;
    double const size = length(along);
    if (size > 0) return along / size;
    return {1, 0};
}

bool is_whole(Arc const& arc) { return std::abs(arc.sweep) >= 2 * pi - angle_rounding; }

// How far `angle` lies beyond the start in the sense of travel, in [0, 2 pi).
double beyond_start(Arc const& arc, double angle) {
    return within_turn(arc.sweep < 0 ? arc.from - angle : angle - arc.from);
}

Nearest end_at(Vec2 const& point, Vec2 const& from) { return {point, length(from - point), false}; }

Nearest nearest_on(Segment const& segment, Vec2 const& from) {
    Vec2 const along = segment.end - segment.start;
    double const reach = dot(along, along);
    double const share = dot(from - segment.start, along);
    if (!(share > 0)) return end_at(segment.start, from);
    if (share >= reach) return end_at(segment.end, from);
    Vec2 const foot = segment.start + along * (share / reach);
    return {foot, std::abs(cross(along, from - segment.start)) / std::sqrt(reach), true};
}

Nearest nearest_on(Arc const& arc, Vec2 const& from) {
    Vec2 const outward = from - arc.centre;
    double const distance = length(outward);
    // From the centre every point is equally near; the middle of the arc stands for them.
    if (distance == 0) return {point_at(arc, arc.from + arc.sweep / 2), arc.radius, true};
    double const beyond = beyond_start(arc, arctangent(outward.y(), outward.x()));
    if (is_whole(arc) || (beyond > 0 && beyond < std::abs(arc.sweep)))
        return {arc.centre + outward * (arc.radius / distance), std::abs(distance - arc.radius), true};
    Nearest const start = end_at(point_at(arc, arc.from), from);
    Nearest const end = end_at(point_at(arc, arc.from + arc.sweep), from);
    return end.distance < start.distance ? end : start;
}

Box with(Box const& box, Vec2 const& point) { return {box.low.cwiseMin(point), box.high.cwiseMax(point)}; }

Box box_around(Arc const& arc) {
    Box box = with(with(Box{}, point_at(arc, arc.from)), point_at(arc, arc.from + arc.sweep));
    Vec2 const sides[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int quarter = 0; quarter < 4; ++quarter)
        if (spans(arc, quarter * (pi / 2))) box = with(box, arc.centre + arc.radius * sides[quarter]);
    return box;
}

}  // namespace

Vec2 start_of(Curve const& curve) {
    return std::visit(Match{[](Segment const& s) -> Vec2 { return s.start; },
                            [](Arc const& a) -> Vec2 { return point_at(a, a.from); }},
                      curve);
}

Vec2 end_of(Curve const& curve) {
    return std::visit(Match{[](Segment const& s) -> Vec2 { return s.end; },
                            [](Arc const& a) -> Vec2 { return point_at(a, a.from + a.sweep); }},
                      curve);
}

double length_of(Curve const& curve) {
    return std::visit(Match{[](Segment const& s) { return length(s.end - s.start); },
                            [](Arc const& a) { return a.radius * std::abs(a.sweep); }},
                      curve);
}

Vec2 tangent_at_start(Curve const& curve) {
    return std::visit(Match{[](Segment const& s) -> Vec2 { return tangent_of(s); },
                            [](Arc const& a) -> Vec2 { return tangent_at(a, a.from); }},
                      curve);
}

Vec2 tangent_at_end(Curve const& curve) {
    return std::visit(Match{[](Segment const& s) -> Vec2 { return tangent_of(s); },
                            [](Arc const& a) -> Vec2 { return tangent_at(a, a.from + a.sweep); }},
                      curve);
}

Curve reversed(Curve const& curve) {
    return std::visit(Match{[](Segment const& s) -> Curve {
                                return Segment{s.end, s.start};
                            },
                            [](Arc const& a) -> Curve {
                                return Arc{a.centre, a.radius, a.from + a.sweep, -a.sweep};
                            }},
                      curve);
}

bool is_whole_circle(Curve const& curve) {
    auto const* arc = std::get_if<Arc>(&curve);
    return arc != nullptr && is_whole(*arc);
}

bool spans(Arc const& arc, double angle) {
    double const beyond = beyond_start(arc, angle);
    return beyond <= std::abs(arc.sweep) + angle_rounding || beyond >= 2 * pi - angle_rounding;
}

Nearest nearest_point(Curve const& curve, Vec2 const& from) {
    return std::visit([&](auto const& piece) { return nearest_on(piece, from); }, curve);
}

Box box_of(Curve const& curve) {
    return std::visit(Match{[](Segment const& s) { return with(with(Box{}, s.start), s.end); },
                            [](Arc const& a) { return box_around(a); }},
                      curve);
}

Extent extent_along(Curve const& curve, Vec2 const& direction) {
    double const start = dot(start_of(curve), direction), end = dot(end_of(curve), direction);
    Extent extent{std::min(start, end), std::max(start, end)};
    if (auto const* arc = std::get_if<Arc>(&curve)) {
        double const middle = dot(arc->centre, direction), angle = arctangent(direction.y(), direction.x());
        if (spans(*arc, angle)) extent.high = middle + arc->radius;
        if (spans(*arc, angle + pi)) extent.low = middle - arc->radius;
    }
    return extent;
}

Box united(Box const& a, Box const& b) { return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)}; }

Box grown(Box const& box, double margin) {
    return {box.low - Vec2::Constant(margin), box.high + Vec2::Constant(margin)};
}

}  // namespace geometry
