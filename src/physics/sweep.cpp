#include "physics/sweep.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "geometry/polynomial.h"

namespace physics {

using geometry::Arc;
using geometry::Box;
using geometry::dot;
using geometry::Segment;

namespace {

using Quartic = std::array<double, 5>;

// Where the gap is closed to within touch_reach it counts as closed exactly, and rates that are rounding count as zero:
// a contact that is just left has no false root next to 0 (physics.md 3.1).
template <std::size_t N>
void snap(std::array<double, N>& gap, double metre, double rate_scale, bool parting) {
    if (!parting && !(std::abs(gap[0]) <= touch_reach * metre)) return;
    gap[0] = 0;
    if (parting ? gap[1] < rate_scale * metre * 1e-12 : std::abs(gap[1]) <= rate_scale * metre * 1e-12) gap[1] = 0;
    if (parting && gap[1] == 0) gap[2] = std::max(gap[2], 0.0);
    if (gap[1] == 0 && std::abs(gap[2]) <= 1e-12 * rate_scale * metre) gap[2] = 0;
}

Parabola after(Parabola const& path, double t) {
    return {path.position + t * (path.velocity + (0.5 * t) * path.acceleration), path.velocity + t * path.acceleration,
            path.acceleration};
}

double rate_scale_of(Parabola const& path) {
    return geometry::length(path.velocity) + geometry::length(path.acceleration);
}

// Calls visit(t) at every fall of the quartic within `until` until it says true; there are at most two.
// `touch_gap` is the value of the gap that touch_reach comes to.
template <typename Visit>
void each_fall(Quartic gap, double touch_gap, double until, Visit&& visit) {
    double start = 0;
    for (int i = 0; i < 4 && start <= until; ++i) {
        if (gap[0] < 0) {
            auto const rise = geometry::first_rise(gap, until - start);
            if (!rise) {
                // A path that joins a curve with its tangent only just comes up to it.
                auto const crest = geometry::first_fall(gap, until - start);
                if (crest && geometry::value_at(gap, *crest) >= -touch_gap) visit(start + *crest);
                return;
            }
            start += *rise;
            double const t = *rise;
            gap = {0.0, gap[1] + t * (2 * gap[2] + t * (3 * gap[3] + t * 4 * gap[4])),
                   gap[2] + t * (3 * gap[3] + t * 6 * gap[4]), gap[3] + t * 4 * gap[4], gap[4]};
        }
        auto const fall = geometry::first_fall(gap, until - start);
        if (!fall || visit(start + *fall)) return;
        double const t = *fall;
        start += t;
        // Past the fall the gap is below zero, however little rounding says.
        gap = {-std::numeric_limits<double>::min(), gap[1] + t * (2 * gap[2] + t * (3 * gap[3] + t * 4 * gap[4])),
               gap[2] + t * (3 * gap[3] + t * 6 * gap[4]), gap[3] + t * 4 * gap[4], gap[4]};
    }
}

class Sweep {
public:
    Sweep(Terrain const& terrain, Parabola const& path, double radius, Contact left, Skipped const& skipped)
        : terrain_(terrain),
          path_(path),
          radius_(radius),
          left_(left),
          skipped_(skipped),
          rates_(rate_scale_of(path)) {}

    // `near` holds all that the ball can touch until then.
    void meet_piece(int index, Box const& near, double until) {
        if (!skipped_.has(index)) {
            if (auto const* segment = std::get_if<Segment>(&terrain_.pieces[index].curve))
                meet_segment(index, *segment, until);
            else
                meet_arc(index, std::get<Arc>(terrain_.pieces[index].curve), until);
        }
        meet_end(index, terrain_.start_vertex[index], near, until);
        meet_end(index, terrain_.end_vertex[index], near, until);
    }

    Obstacle first;

private:
    void offer(double t, Contact contact) {
        if (t < first.time || (t == first.time && contact.feature < first.contact.feature)) first = {t, contact};
    }
    bool is_left(Contact contact) const { return contact == left_; }

    void meet_segment(int index, Segment const& segment, double until) {
        Vec2 const way = segment.end - segment.start;
        double const span = geometry::length(way);
        Vec2 const along = way / span;
        Vec2 const left = geometry::turned_left(along);
        double const height = dot(path_.position - segment.start, left);
        double const rate = dot(path_.velocity, left);
        double const bend = 0.5 * dot(path_.acceleration, left);
        for (int const side : {1, -1}) {
            Contact const contact{index, side};
            std::array<double, 3> gap{side * height - radius_, side * rate, side * bend};
            snap(gap, 1, rates_, is_left(contact));
            auto const t = fall_of(gap, std::min(until, first.time));
            if (!t) continue;
            double const foot = dot(after(path_, *t).position - segment.start, along);
            if (foot < -touch_reach || foot > span + touch_reach) continue;
            bool const grazes = *t == 0 && gap[1] == 0;
            if (grazes && runs_off(foot, dot(path_.velocity, along), span)) continue;
            offer(*t, contact);
        }
    }

    // A ball that touches without closing, at an end and going beyond it, has left the piece.
    static bool runs_off(double foot, double speed, double span) {
        return (foot <= touch_reach && speed < 0) || (foot >= span - touch_reach && speed > 0);
    }

    // The falling root of a quadratic, also of one that starts below zero, where it must rise first.
    static std::optional<double> fall_of(std::array<double, 3> const& gap, double until) {
        if (gap[0] >= 0) return geometry::first_quadratic_fall(gap[0], gap[1], gap[2], until);
        double const discriminant = gap[1] * gap[1] - 4 * gap[0] * gap[2];
        if (!(gap[2] < 0 && gap[1] > 0)) return std::nullopt;
        // A path that joins the line with its tangent only just comes up to it.
        if (discriminant < 4 * gap[2] * touch_reach) return std::nullopt;
        double const t = (gap[1] + std::sqrt(std::max(0.0, discriminant))) / (-2 * gap[2]);
        return t <= until ? std::optional(t) : std::nullopt;
    }

    void meet_arc(int index, Arc const& arc, double until) {
        int const inner_side = arc.sweep > 0 ? 1 : -1;
        meet_circle(arc.centre, arc.radius + radius_, 1, {index, -inner_side}, until,
                    [&](Vec2 const& out) { return spans_loosely(arc, out); });
        if (!fits(terrain_, {index, inner_side}, radius_)) return;
        meet_circle(arc.centre, arc.radius - radius_, -1, {index, inner_side}, until,
                    [&](Vec2 const& out) { return spans_loosely(arc, out); });
    }

    void meet_end(int index, int vertex, Box const& near, double until) {
        if (vertex < 0 || terrain_.vertices[vertex].spokes.front().piece != index) return;
        int const feature = terrain_.feature_of_vertex(vertex);
        Vertex const& v = terrain_.vertices[vertex];
        if (v.cone_width == 0 || skipped_.has(feature) || !overlap(near, {v.point, v.point})) return;
        if (is_beside_a_piece(v, near)) return;
        meet_circle(v.point, radius_, 1, {feature, 1}, until, [&](Vec2 const& out) { return exposes(v, out); });
    }

    // Whether all of the way, and a moment beyond, lies beside one of the vertex's pieces: then the vertex is not
    // exposed to it.
    bool is_beside_a_piece(Vertex const& v, Box const& near) const {
        Vec2 const margin = Vec2::Constant(radius_ + touch_reach);
        Vec2 const low = near.low + margin - v.point, high = near.high - margin - v.point;
        return std::any_of(v.spokes.begin(), v.spokes.end(), [&](Spoke const& spoke) {
            Vec2 const& d = spoke.direction;
            return dot({d.x() > 0 ? low.x() : high.x(), d.y() > 0 ? low.y() : high.y()}, d) > 8 * touch_reach;
        });
    }

    // sense +1: from outside of the circle that bounds the centre, -1: from inside of it.
    template <typename Admits>
    void meet_circle(Vec2 const& centre, double rho, int sense, Contact contact, double until, Admits&& admits) {
        Quartic gap = geometry::distance_quartic(path_.position - centre, path_.velocity, path_.acceleration, rho);
        for (double& c : gap) c *= sense;
        snap(gap, 2 * rho, rates_, is_left(contact));
        bool const grazes = gap[0] == 0 && gap[1] == 0;
        each_fall(gap, 2 * rho * touch_reach, std::min(until, first.time), [&](double t) {
            // Touching without closing, look a moment ahead: at an end the ball may be running off the arc.
            double const speed = geometry::length(path_.velocity);
            double const ahead = grazes && t == 0 && speed > 0 ? 4 * touch_reach / speed : 0;
            Vec2 const out = after(path_, t + ahead).position - centre;
            double const distance = geometry::length(out);
            if (distance == 0 || !admits(Vec2(out / distance))) return false;
            offer(t, contact);
            return true;
        });
    }

    Terrain const& terrain_;
    Parabola const& path_;
    double radius_;
    Contact left_;
    Skipped const& skipped_;
    double rates_;
};

Box box_of_path(Parabola const& path, double from, double to) {
    Box box;
    auto const include = [&](double t) {
        Vec2 const p = after(path, t).position;
        box.low = box.low.cwiseMin(p);
        box.high = box.high.cwiseMax(p);
    };
    include(from);
    include(to);
    for (int axis = 0; axis < 2; ++axis) {
        if (path.acceleration[axis] == 0) continue;
        double const turn = -path.velocity[axis] / path.acceleration[axis];
        if (turn > from && turn < to) include(turn);
    }
    return box;
}

// Out of the terrain's bounds for good: beyond one of them, going away and drawn away.
bool gone(Terrain const& terrain, Parabola const& now, double radius) {
    for (int axis = 0; axis < 2; ++axis) {
        double const v = now.velocity[axis], a = now.acceleration[axis];
        if (now.position[axis] > terrain.bounds.high[axis] + 2 * radius && v >= 0 && a >= 0) return true;
        if (now.position[axis] < terrain.bounds.low[axis] - 2 * radius && v <= 0 && a <= 0) return true;
    }
    return false;
}

// Radii of way in the first look, and by how much each later one is longer. In flight along a chain of short chords the
// next one is met soon, and what lies farther ahead need not be seen; on a track there is hardly ever anything to meet,
// and of few pieces none is in the way of the others.
constexpr double first_window = 1.0 / 16;
constexpr double first_window_in_the_open = 4;
constexpr double window_growth = 8;
constexpr std::size_t few_pieces = 16;

// The time in which a path covers about `way`.
double time_for(Parabola const& now, double way) {
    double const speed = geometry::length(now.velocity);
    double const a = geometry::length(now.acceleration);
    double const denominator = speed + std::sqrt(speed * speed + 2 * a * way);
    return denominator > 0 ? 2 * way / denominator : never;
}

}  // namespace

bool spans_loosely(Arc const& arc, Vec2 const& out) {
    double const slack = std::copysign(touch_reach / arc.radius, arc.sweep);
    Arc const wider{arc.centre, arc.radius, arc.from - slack, arc.sweep + 2 * slack};
    return std::abs(wider.sweep) >= 2 * geometry::pi || geometry::spans(wider, angle_of(out));
}

Obstacle first_obstacle(Terrain const& terrain, Parabola const& path, double radius, double until, Contact left,
                        Skipped const& skipped) {
    Sweep sweep(terrain, path, radius, left, skipped);
    if (terrain.pieces.empty()) return sweep.first;
    double from = 0;
    bool const in_the_open = until < never || terrain.pieces.size() <= few_pieces;
    double way = (in_the_open ? first_window_in_the_open : first_window) * radius;
    while (from < until) {
        Parabola const now = after(path, from);
        if (gone(terrain, now, radius)) break;
        double const to = std::min(until, from + time_for(now, way));
        if (to == never || !(to > from)) break;
        Box const near = grown(box_of_path(path, from, to), radius + touch_reach);
        // A parabola is nowhere farther from its chord than this.
        double const sagitta = geometry::length(path.acceleration) * (to - from) * (to - from) / 8;
        geometry::Stroke const stroke{now.position, after(path, to).position, radius + touch_reach + sagitta, near};
        terrain.tree.each_near(stroke, [&](int piece) { sweep.meet_piece(piece, near, to); });
        if (sweep.first.time <= to) return sweep.first;
        from = to;
        way *= window_growth;
    }
    return sweep.first;
}

}  // namespace physics
