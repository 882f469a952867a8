#include "level/ellipse.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/elementary.h"

namespace level {

using geometry::cross;
using geometry::dot;
using geometry::EllipticArc;
using geometry::pi;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace

EllipticArc elliptical_arc(Vec2 const& start, ArcTo const& arc) {
    geometry::SineCosine const turn = geometry::sine_cosine(std::fmod(arc.rotation, 360.0) * (pi / 180));
    // In units of the radii and along the ellipse's axes it is a circle of radius one.
    Vec2 const half = geometry::turned((start - arc.end) / 2, turn.cosine, -turn.sine);
    double const reach =
        std::sqrt((half.x() / arc.rx) * (half.x() / arc.rx) + (half.y() / arc.ry) * (half.y() / arc.ry));
    double const growth = std::max(1.0, reach);
    double const rx = arc.rx * growth, ry = arc.ry * growth;
    Vec2 const unit_half(half.x() / rx, half.y() / ry);
    double const square = dot(unit_half, unit_half);
    // Half a circle is drawn with a chord of two radii, which rounding must not bend: the centre answers to the square
    // root of an error there.
    double const far = geometry::length(start) + geometry::length(arc.end);
    double const rounding = 8 * epsilon * (1 + far / geometry::length(start - arc.end));
    double const away = 1 - square > rounding ? std::sqrt(1 / square - 1) : 0;
    double const side = arc.large == arc.sweep ? -1 : 1;
    Vec2 const unit_centre = geometry::turned_right(unit_half) * (side * away);

    Vec2 const from = unit_half - unit_centre, to = -unit_half - unit_centre;
    double sweep = geometry::arctangent(cross(from, to), dot(from, to));
    if (arc.sweep && sweep < 0) sweep += 2 * pi;
    if (!arc.sweep && sweep > 0) sweep -= 2 * pi;

    EllipticArc result;
    result.first = Vec2(turn.cosine, turn.sine) * rx;
    result.second = Vec2(-turn.sine, turn.cosine) * ry;
    result.centre = (start + arc.end) / 2 + result.first * unit_centre.x() + result.second * unit_centre.y();
    result.from = geometry::arctangent(from.y(), from.x());
    result.sweep = sweep;
    return result;
}

EllipticArc mapped(Affine const& map, EllipticArc const& arc) {
    return {mapped(map, arc.centre), mapped_direction(map, arc.first), mapped_direction(map, arc.second), arc.from,
            arc.sweep};
}

bool is_circular(EllipticArc const& arc) {
    double const a = dot(arc.first, arc.first), b = dot(arc.second, arc.second);
    // Squares: twice the slack of the lengths.
    double const slack = 2 * similarity_slack * std::max(a, b);
    return std::abs(a - b) <= slack && std::abs(dot(arc.first, arc.second)) <= slack;
}

geometry::Arc arc_between(Vec2 const& start, Vec2 const& end, double radius, Way way, Turn turn) {
    Vec2 const chord = end - start;
    double const half = geometry::length(chord) / 2;
    double const reaching = std::max(radius, half);
    double const away = std::sqrt(std::max(0.0, (reaching - half) * (reaching + half)));
    bool const centre_on_left = (turn == Turn::left) == (way == Way::shorter);
    Vec2 const aside = geometry::turned_left(chord) * ((centre_on_left ? away : -away) / (2 * half));

    geometry::Arc arc;
    arc.centre = (start + end) / 2 + aside;
    arc.radius = reaching;
    Vec2 const from = start - arc.centre;
    arc.from = geometry::arctangent(from.y(), from.x());
    double const shorter = 2 * geometry::arctangent(half, away);
    double const sweep = way == Way::shorter ? shorter : 2 * pi - shorter;
    arc.sweep = turn == Turn::left ? sweep : -sweep;
    return arc;
}

}  // namespace level
