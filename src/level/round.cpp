#include "level/round.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/elementary.h"
#include "level/faults.h"
#include "level/inside.h"
#include "level/limits.h"
#include "level/outlines.h"

namespace level {

namespace {

using physics::DiscRegion;

// The greatest and the least radius of an ellipse under a map: the singular values of its two axes.
std::pair<double, double> radii_of(Ellipse const& ellipse, Affine const& map) {
    Vec2 const first = mapped_direction(map, {ellipse.rx, 0}), second = mapped_direction(map, {0, ellipse.ry});
    double const squares = geometry::dot(first, first) + geometry::dot(second, second);
    double const area = 2 * std::abs(geometry::cross(first, second));
    double const sum = std::sqrt(squares + area), difference = std::sqrt(std::max(0.0, squares - area));
    return {(sum + difference) / 2, (sum - difference) / 2};
}

DiscRegion checked(DiscRegion const& disc) {
    if (!(disc.radius > 0)) throw Broken("the radius must be greater than 0, got " + shown(disc.radius));
    if (!(disc.radius <= most_metres)) throw TooFar("a radius must be at most 1e6 m, got " + shown(disc.radius), true);
    return disc;
}

std::optional<DiscRegion> disc_in(Ellipse const& ellipse, Affine const& map) {
    DiscRegion const disc{placed(map, ellipse.centre),
                          (ellipse.rx == ellipse.ry ? ellipse.rx : std::sqrt(ellipse.rx * ellipse.ry)) * scale_of(map)};
    auto const [greatest, least] = radii_of(ellipse, map);
    if (!(greatest - least <= roundness * greatest)) return std::nullopt;
    return checked(disc);
}

bool is_of_beziers(std::vector<Subpath> const& subpaths) {
    auto const bends = [](Draw const& draw) {
        return std::holds_alternative<CubicTo>(draw) || std::holds_alternative<QuadraticTo>(draw);
    };
    auto const all_bend = [&](Subpath const& subpath) {
        // But for the way back to a start that rounding left beside the end.
        std::span<Draw const> draws(subpath.draws);
        bool const returns = subpath.closed && draws.size() > 1 && !bends(draws.back());
        if (returns) draws = draws.first(draws.size() - 1);
        return std::all_of(draws.begin(), draws.end(), bends);
    };
    return !subpaths.empty() && std::all_of(subpaths.begin(), subpaths.end(), all_bend);
}

bool is_within(DiscRegion const& disc, Outline const& outline, double slack) {
    constexpr int samples = 8;  // of each curve
    for (geometry::Curve const& curve : outline.curves)
        for (int i = 0; i <= samples; ++i) {
            Vec2 const point = point_along(curve, static_cast<double>(i) / samples);
            double const off = std::abs(geometry::length(point - disc.centre) - disc.radius);
            if (!(off <= slack * disc.radius)) return false;
        }
    return true;
}

// The circle that arcs agree on, to the last digits; else the one in the middle of the outline's box.
DiscRegion circle_through(Outline const& outline) {
    geometry::Box const box = box_of(std::span(&outline, 1));
    Vec2 const extent = box.high - box.low;
    DiscRegion const by_box{(box.low + box.high) / 2, (extent.x() + extent.y()) / 4};
    DiscRegion by_arcs;
    double const share = 1.0 / static_cast<double>(outline.curves.size());
    for (geometry::Curve const& curve : outline.curves) {
        auto const* arc = std::get_if<geometry::Arc>(&curve);
        constexpr double agreement = 1e-9;  // of the radius
        bool const agrees = arc != nullptr && std::abs(arc->radius - by_box.radius) <= agreement * by_box.radius &&
                            geometry::length(arc->centre - by_box.centre) <= agreement * by_box.radius;
        if (!agrees) return by_box;
        by_arcs.centre += arc->centre * share;
        by_arcs.radius += arc->radius * share;
    }
    return by_arcs;
}

std::optional<DiscRegion> disc_in(std::vector<Subpath> const& subpaths, Affine const& map) {
    constexpr double first_look = 1e-3;  // m
    constexpr double fine = 1e-5;        // of the size, a hundredth of what a circle may be off
    std::vector<Outline> outlines = traced(subpaths, map, first_look).outlines;
    if (outlines.size() != 1) return std::nullopt;
    geometry::Box const box = box_of(outlines);
    double const size = geometry::length(box.high - box.low);
    if (size * fine < first_look) outlines = traced(subpaths, map, size * fine).outlines;
    if (outlines.size() != 1 || !outlines[0].closed) return std::nullopt;
    DiscRegion const disc = circle_through(outlines[0]);
    double const slack = is_of_beziers(subpaths) ? roundness_of_beziers : roundness;
    bool const round = is_within(disc, outlines[0], slack) && std::abs(winding_round(outlines, disc.centre)) == 1;
    return round ? std::optional(checked(disc)) : std::nullopt;
}

}  // namespace

std::optional<DiscRegion> disc_of(Shape const& shape, Affine const& to_world) {
    return std::visit([&](auto const& s) { return disc_in(s, to_world); }, shape);
}

std::string why_not_round(Shape const& shape, Affine const& to_world, std::string_view tag) {
    if (tag == "circle") return "transform must keep a circle a circle; make width and height the same";
    auto const* ellipse = std::get_if<Ellipse>(&shape);
    if (ellipse == nullptr) {
        auto const& subpaths = std::get<std::vector<Subpath>>(shape);
        bool const coarse = is_of_beziers(subpaths);
        return std::string("it is not a circle to ") + (coarse ? "5e-3" : "1e-3") +
               " of its radius; draw a circle, or a path that is one";
    }
    auto const [greatest, least] = radii_of(*ellipse, to_world);
    return "its radii must be equal to 1e-3, got " + shown(greatest) + " m and " + shown(least) +
           " m; make width and height the same";
}

}  // namespace level
