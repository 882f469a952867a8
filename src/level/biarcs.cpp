#include "level/biarcs.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "level/limits.h"

namespace level {

using geometry::Curve;
using geometry::dot;
using geometry::wedge;

namespace {

// A point of a curve with the unit tangent there.
struct Pose {
    Vec2 point = Vec2::Zero(), way = Vec2::UnitX();
};

Pose pose_at(Cubic const& c, double t) {
    double const u = 1 - t;
    Vec2 const a = c.first - c.start, b = c.second - c.first, d = c.end - c.second;
    Pose pose{u * u * u * c.start + 3 * u * u * t * c.first + 3 * u * t * t * c.second + t * t * t * c.end,
              Vec2::UnitX()};
    // Where a control point lies on an end, or at a cusp, the next derivative gives the way.
    Vec2 const size = (c.first - c.start).cwiseAbs() + b.cwiseAbs() + d.cwiseAbs();
    double const nothing = 1e-9 * (size.x() + size.y());
    Vec2 way = u * u * a + 2 * u * t * b + t * t * d;
    if (geometry::length(way) <= nothing) way = (u * (b - a) + t * (d - b)) * (t < 0.5 ? 1 : -1);
    if (geometry::length(way) <= nothing) way = c.end - c.start;
    if (double const length = geometry::length(way); length > 0) pose.way = way / length;
    return pose;
}

Pose pose_at(EllipticalArc const& arc, double t) {
    geometry::SineCosine const turn = geometry::sine_cosine(arc.from + arc.sweep * t);
    Vec2 const way = (arc.sine_axis * turn.cosine - arc.cosine_axis * turn.sine) * (arc.sweep < 0 ? -1 : 1);
    Pose pose{arc.centre + arc.cosine_axis * turn.cosine + arc.sine_axis * turn.sine, Vec2::UnitX()};
    if (double const length = geometry::length(way); length > 0) pose.way = way / length;
    return pose;
}

// The arc that leaves a pose and ends in a point.
Curve arc_from(Pose const& pose, Vec2 const& end) {
    Vec2 const chord = end - pose.point;
    double const aside = wedge(pose.way, chord);
    double const square = dot(chord, chord);
    if (std::abs(aside) * (2 * most_metres) <= square) return geometry::Segment{pose.point, end};
    double const radius = square / (2 * aside);  // positive to the left
    Vec2 const centre = pose.point + geometry::turned_left(pose.way) * radius;
    Vec2 const from = pose.point - centre;
    return geometry::Arc{centre, std::abs(radius), geometry::arctangent(from.y(), from.x()),
                         2 * geometry::arctangent(aside, dot(pose.way, chord))};
}

// Two arcs with a common tangent where they meet, both ends' tangents given: the tangents' lengths to the corners are
// the same, d, so that |p1 - p0 - d (t0 + t1)| = 2 d.
struct Pair {
    Curve first, second;
};
Pair pair_between(Pose const& a, Pose const& b) {
    Vec2 const chord = b.point - a.point, sum = a.way + b.way;
    double const along = dot(chord, sum);
    double const bend = 2 * (1 - dot(a.way, b.way));
    double const square = dot(chord, chord);
    double const d = square / (along + std::sqrt(along * along + bend * square));
    Vec2 const middle = (a.point + d * a.way + (b.point - d * b.way)) / 2;
    return {arc_from(a, middle), reversed(arc_from({b.point, -b.way}, middle))};
}

template <typename Smooth>
class Fitter {
public:
    Fitter(Smooth const& curve, double tolerance) : curve_(curve), tolerance_(tolerance) {}

    std::vector<Curve> arcs() {
        // Four parts to begin with: a closed or S-shaped curve has no pair of arcs of its own.
        for (int i = 0; i < 4; ++i) fit({i / 4.0, (i + 1) / 4.0}, 0);
        return std::move(arcs_);
    }

private:
    struct Span {
        double from = 0, to = 1;
    };

    void fit(Span span, int depth) {
        constexpr int deepest = 24;
        Pose const a = pose_at(curve_, span.from), b = pose_at(curve_, span.to);
        double const size = geometry::length(b.point - a.point);
        bool const turns_gently = dot(a.way, b.way) > 0.5 && dot(b.point - a.point, a.way) > 0.5 * size &&
                                  dot(b.point - a.point, b.way) > 0.5 * size;
        if (turns_gently) {
            Pair const pair = pair_between(a, b);
            if (deepest <= depth || is_near(pair, span)) {
                arcs_.push_back(pair.first);
                arcs_.push_back(pair.second);
                return;
            }
        }
        bool const hopeless = depth >= deepest || size <= shortest_piece / 4;
        if (hopeless && depth > 8) {
            arcs_.push_back(geometry::Segment{a.point, b.point});
            return;
        }
        double const middle = (span.from + span.to) / 2;
        fit({span.from, middle}, depth + 1);
        fit({middle, span.to}, depth + 1);
    }

    bool is_near(Pair const& pair, Span span) const {
        constexpr int samples = 16;
        // Samples miss the farthest point by a little.
        double const allowed = 0.9 * tolerance_;
        for (int i = 1; i < samples; ++i) {
            Vec2 const point = pose_at(curve_, span.from + (span.to - span.from) * i / samples).point;
            double const distance = std::min(geometry::nearest_point(pair.first, point).distance,
                                             geometry::nearest_point(pair.second, point).distance);
            if (distance > allowed) return false;
        }
        return true;
    }

    Smooth const& curve_;
    double tolerance_;  // m
    std::vector<Curve> arcs_;
};

}  // namespace

std::vector<Curve> arcs_of(Cubic const& cubic, double tolerance) { return Fitter(cubic, tolerance).arcs(); }

std::vector<Curve> arcs_of(EllipticalArc const& arc, double tolerance) { return Fitter(arc, tolerance).arcs(); }

}  // namespace level
