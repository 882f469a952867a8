#include "level/outlines.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/biarc.h"
#include "geometry/elementary.h"
#include "level/ellipse.h"
#include "level/faults.h"
#include "level/limits.h"

namespace level {

using geometry::Curve;
using geometry::Segment;

namespace {

// Whether the control points lie on the chord and in its order, so that the curve is the chord itself.
bool is_straight(Vec2 const& a, Vec2 const& first, Vec2 const& second, Vec2 const& b) {
    constexpr double slack = 1e-9;  // m, far below the tolerance of any curve
    Vec2 const chord = b - a;
    double const size = geometry::length(chord);
    if (!(size > slack)) return false;
    auto const along = [&](Vec2 const& p) { return geometry::dot(p - a, chord) / size; };
    auto const aside = [&](Vec2 const& p) { return std::abs(geometry::cross(p - a, chord)) / size; };
    double const from = along(first), to = along(second);
    return aside(first) <= slack && aside(second) <= slack && from >= -slack && from <= to + slack &&
           to <= size + slack;
}

class Tracer {
public:
    Tracer(Affine const& to_world, double tolerance) : map_(to_world), tolerance_(tolerance) {}

    Traced of(std::vector<Subpath> const& subpaths) {
        for (Subpath const& subpath : subpaths) trace(subpath);
        return std::move(traced_);
    }

    Traced of(Ellipse const& ellipse) {
        placed(map_, ellipse.centre);
        geometry::EllipticArc arc = whole(ellipse);
        outline_ = Outline{{}, true};
        if (is_circular(arc)) {
            double const radius = checked_radius(std::sqrt(geometry::length(arc.first) * geometry::length(arc.second)));
            if (radius > shortest_piece)
                outline_.curves.push_back(geometry::Arc{arc.centre, radius, 0, 2 * geometry::pi});
        } else {
            append_ellipse(arc);
        }
        if (outline_.curves.empty()) ++traced_.dropped;
        keep_outline();
        return std::move(traced_);
    }

private:
    geometry::EllipticArc whole(Ellipse const& ellipse) const {
        geometry::EllipticArc const arc{ellipse.centre, {ellipse.rx, 0}, {0, ellipse.ry}, 0, 2 * geometry::pi};
        return mapped(map_, arc);
    }

    void trace(Subpath const& subpath) {
        outline_ = Outline{{}, subpath.closed};
        at_ = subpath.start;
        for (std::size_t i = 0; i < subpath.draws.size(); ++i) {
            Draw const& draw = subpath.draws[i];
            std::size_t const before = outline_.curves.size();
            std::visit([&](auto const& d) { append(d); }, draw);
            // Editors close what already ends where it began but for rounding; that is no piece to miss.
            bool const closes = subpath.closed && i + 1 == subpath.draws.size();
            if (outline_.curves.size() == before && !closes) ++traced_.dropped;
            at_ = end_of(draw);
        }
        keep_outline();
    }

    void keep_outline() {
        if (outline_.curves.empty()) return;
        Vec2 const gap = geometry::end_of(outline_.curves.back()) - geometry::start_of(outline_.curves.front());
        outline_.closed = outline_.closed || geometry::length(gap) <= shortest_piece;
        traced_.outlines.push_back(std::move(outline_));
    }

    void append(LineTo const& line) { keep(Segment{placed(map_, at_), placed(map_, line.end)}); }

    void append(ArcTo const& arc) {
        Vec2 const start = placed(map_, at_), end = placed(map_, arc.end);
        if (at_ == arc.end) return;
        if (arc.rx == 0 || arc.ry == 0) return keep(Segment{start, end});
        geometry::EllipticArc const ellipse = mapped(map_, elliptical_arc(at_, arc));
        if (!is_circular(ellipse)) return append_ellipse(ellipse);
        if (geometry::length(end - start) > shortest_piece || arc.large) keep(circular_arc(arc, ellipse, start, end));
    }

    // The drawn circle carried over whole, unless its transform is no similarity to the last digit: then the ends stay
    // where they were drawn.
    geometry::Arc circular_arc(ArcTo const& arc, geometry::EllipticArc const& ellipse, Vec2 const& start,
                               Vec2 const& end) const {
        constexpr double slack = 1e-9;  // m, far below the reach of a vertex
        double const radius =
            checked_radius(std::sqrt(geometry::length(ellipse.first) * geometry::length(ellipse.second)));
        Vec2 const from = start - ellipse.centre;
        double const sweep = determinant(map_) > 0 ? ellipse.sweep : -ellipse.sweep;
        geometry::Arc const whole{ellipse.centre, radius, geometry::arctangent(from.y(), from.x()), sweep};
        bool const ends_meet = geometry::length(geometry::start_of(whole) - start) <= slack &&
                               geometry::length(geometry::end_of(whole) - end) <= slack;
        if (ends_meet) return whole;
        return arc_between(start, end, radius, arc.large ? Way::longer : Way::shorter,
                           sweep > 0 ? Turn::left : Turn::right);
    }

    void append(QuadraticTo const& curve) {
        append(CubicTo{at_ + (curve.control - at_) * (2.0 / 3), curve.end + (curve.control - curve.end) * (2.0 / 3),
                       curve.end});
    }

    void append(CubicTo const& curve) {
        Vec2 const a = placed(map_, at_), first = placed(map_, curve.first), second = placed(map_, curve.second),
                   b = placed(map_, curve.end);
        if (is_straight(a, first, second, b)) return keep(Segment{a, b});
        bool const point =
            geometry::length(first - a) + geometry::length(second - a) + geometry::length(b - a) <= shortest_piece;
        if (point) return;
        for (Curve const& piece : geometry::arcs_of_cubic(a, first, second, b, tolerance_)) keep(piece);
    }

    void append_ellipse(geometry::EllipticArc const& arc) {
        checked_radius(geometry::length(arc.first));
        checked_radius(geometry::length(arc.second));
        for (Curve const& piece : geometry::arcs_of_ellipse(arc, tolerance_)) keep(piece);
    }

    double checked_radius(double radius) const {
        if (!(radius <= most_metres)) throw TooFar("a radius must be at most 1e6 m, got " + shown(radius), true);
        return radius;
    }

    void keep(Curve const& curve) {
        if (geometry::length_of(curve) > shortest_piece) outline_.curves.push_back(curve);
    }

    Affine map_;
    double tolerance_;  // m
    Traced traced_;
    Outline outline_;
    Vec2 at_ = Vec2::Zero();  // where the pen is, in the drawing's units
};

}  // namespace

Vec2 placed(Affine const& to_world, Vec2 const& point) {
    Vec2 const place = mapped(to_world, point);
    for (double const x : {place.x(), place.y()})
        if (!(std::abs(x) <= most_metres)) throw TooFar("a coordinate must be at most 1e6 m, got " + shown(x));
    return place;
}

Traced traced(Shape const& shape, Affine const& to_world, double tolerance) {
    Tracer tracer(to_world, tolerance);
    return std::visit([&](auto const& s) { return tracer.of(s); }, shape);
}

}  // namespace level
