// Sweeps of a ball that flies on the drag spring: conservative advancement on |acceleration| <= M (physics.md 3.2).
#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "physics/sweep.h"

namespace physics {

using geometry::Arc;
using geometry::dot;

namespace {

constexpr double gap_accuracy = 1e-13;  // m, how near counts as met
constexpr int advancement_cap = 20000;  // steps; grazing an end at a joint's least turn takes a few thousand
// Shares of the spring's time 1/omega: a ball that lifts by acceleration alone goes on lifting for the first, and no
// path bends back by more than gap_accuracy in the second.
constexpr double lifting = 1e-3;
constexpr double blink = 1e-6;

// A time in which a gap that closes at `closing` with its rate of closing growing by at most `bound` stays open.
double open_time(double gap, double closing, double bound) {
    double const denominator = closing + std::sqrt(closing * closing + 2 * bound * gap);
    if (denominator <= 0) return never;
    // closing < 0 opens first: the unstable sum is avoided by its conjugate.
    if (closing < 0) return bound > 0 ? (std::sqrt(closing * closing + 2 * bound * gap) - closing) / bound : never;
    return 2 * gap / denominator;
}

struct SpringSweep {
    Terrain const& terrain;
    Leg const& leg;
    double radius;
    double bound;  // m/s^2
    double speed;  // m/s, never exceeded in the window

    // A safe time from the state to any contact with the piece or its ends.
    double safe_time(int index, State const& state) const {
        geometry::Curve const& curve = terrain.pieces[index].curve;
        geometry::Nearest const nearest = geometry::nearest_point(curve, state.position);
        double const gap = std::max(0.0, nearest.distance - radius);
        if (std::holds_alternative<geometry::Segment>(curve)) return open_time(gap, -rate_from(nearest, state), bound);
        Arc const& arc = std::get<Arc>(curve);
        double const between = std::max(safe_time_to_circle(arc, state), safe_time_to_offsets(arc, state));
        double const start = safe_time_to_point(geometry::start_of(curve), state);
        return std::min({between, start, safe_time_to_point(geometry::end_of(curve), state)});
    }

    double safe_time_to_point(Vec2 const& point, State const& state) const {
        Vec2 const out = state.position - point;
        double const d = geometry::length(out);
        return d > radius ? open_time(d - radius, -dot(out, state.velocity) / d, bound) : 0;
    }

    // To the arcs on which the centre is while the ball touches the curve between its ends: no nearer than as the crow
    // flies.
    double safe_time_to_offsets(Arc const& arc, State const& state) const {
        double way = never;
        for (double const rho : {arc.radius + radius, arc.radius - radius}) {
            if (rho <= 0) continue;
            way = std::min(way,
                           geometry::nearest_point(Arc{arc.centre, rho, arc.from, arc.sweep}, state.position).distance);
        }
        return open_time(way, geometry::length(state.velocity), bound);
    }

    // Whether a ball that touches without closing is pushed on by what it will have done a little later.
    bool presses(int piece, double t, double later) const {
        auto const distance = [&](double time) {
            State const state = at(leg, leg.since + time);
            return geometry::nearest_point(terrain.pieces[piece].curve, state.position).distance;
        };
        return distance(t + later) < distance(t) - gap_accuracy;
    }

    // The second derivative of the distance to the piece from where the ball is, the curve's own bend included.
    double bending(int piece, Vec2 const& normal, State const& state) const {
        auto const& flight = std::get<SpringFlight>(leg.motion);
        Vec2 const acceleration = flight.oscillator.stiffness * (flight.equilibrium - state.position) -
                                  2 * flight.oscillator.decay * state.velocity;
        double const straight = dot(acceleration, normal);
        double const speed_along = geometry::wedge(normal, state.velocity);
        geometry::Nearest const nearest = geometry::nearest_point(terrain.pieces[piece].curve, state.position);
        if (!nearest.inside) return straight + speed_along * speed_along / radius;
        auto const* arc = std::get_if<Arc>(&terrain.pieces[piece].curve);
        if (arc == nullptr) return straight;
        Vec2 const out = state.position - arc->centre;
        double const distance = geometry::length(out);
        return straight + std::copysign(speed_along * speed_along / distance, dot(out, normal));
    }

    // Inside an arc a ball that leaves it comes back sooner than its acceleration alone would have it.
    double bound_near(int piece, State const& state) const {
        auto const* arc = std::get_if<Arc>(&terrain.pieces[piece].curve);
        if (arc == nullptr) return bound;
        double const d = geometry::length(state.position - arc->centre);
        return d < arc->radius && d > 0 ? bound + 2 * speed * speed / d : bound;
    }

    static double rate_from(geometry::Nearest const& nearest, State const& state) {
        return nearest.distance > 0 ? dot(state.position - nearest.point, state.velocity) / nearest.distance : 0;
    }

    // To the whole circle of the arc; 0 while the centre is in the band that the circle itself would forbid.
    double safe_time_to_circle(Arc const& arc, State const& state) const {
        Vec2 const out = state.position - arc.centre;
        double const d = geometry::length(out);
        if (d == 0) return 0;
        double const rate = dot(out, state.velocity) / d;
        if (d >= arc.radius + radius) return open_time(d - arc.radius - radius, -rate, bound);
        double const inner = arc.radius - radius;
        if (!(d <= inner)) return 0;
        // Inside, the distance from the centre may grow faster: |d''| <= M + V^2/d, for as long as d stays above half.
        if (d < 0.5 * inner) return (inner - d) / (2 * speed + 1e-300);
        double const time = open_time(inner - d, rate, bound + 2 * speed * speed / d);
        return std::min(time, 0.5 * d / (speed + 1e-300));
    }

    Contact contact_with(int index, State const& state) const {
        geometry::Curve const& curve = terrain.pieces[index].curve;
        geometry::Nearest const nearest = geometry::nearest_point(curve, state.position);
        if (!nearest.inside) {
            int const start = terrain.start_vertex[index];
            bool const at_start = start >= 0 && geometry::length(nearest.point - geometry::start_of(curve)) <
                                                    geometry::length(nearest.point - geometry::end_of(curve));
            int const vertex = at_start ? start : terrain.end_vertex[index];
            Vec2 const out = (state.position - terrain.vertices[vertex].point) / nearest.distance;
            if (exposes(terrain.vertices[vertex], out)) return {terrain.feature_of_vertex(vertex), 1};
        }
        return {index, side_of(curve, state.position)};
    }

    static int side_of(geometry::Curve const& curve, Vec2 const& position) {
        if (auto const* segment = std::get_if<geometry::Segment>(&curve))
            return geometry::wedge(segment->end - segment->start, position - segment->start) > 0 ? 1 : -1;
        Arc const& arc = std::get<Arc>(curve);
        bool const inside = geometry::length(position - arc.centre) < arc.radius;
        return inside == (arc.sweep > 0) ? 1 : -1;
    }
};

}  // namespace

Obstacle first_obstacle(Terrain const& terrain, Leg const& spring_flight, double radius, double from, double until,
                        Contact left) {
    State const start = at(spring_flight, spring_flight.since + from);
    double const bound = acceleration_bound(spring_flight, spring_flight.since + from, spring_flight.since + until);
    double const span = until - from;
    double const speed = geometry::length(start.velocity) + bound * span;
    SpringSweep const sweep{terrain, spring_flight, radius, bound, speed};
    Vec2 const reach =
        Vec2::Constant(std::min(speed * span, geometry::length(start.velocity) * span + 0.5 * bound * span * span) +
                       radius + touch_reach);
    Obstacle first{until, no_contact};
    double const frequency = std::sqrt(std::get<SpringFlight>(spring_flight.motion).oscillator.stiffness);
    terrain.tree.each_overlapping({start.position - reach, start.position + reach}, [&](int piece) {
        double t = from;
        for (int i = 0; t < first.time; ++i) {
            if (i == advancement_cap) {
                first = {t, no_contact};
                return;
            }
            State const state = at(spring_flight, spring_flight.since + t);
            geometry::Nearest const nearest = geometry::nearest_point(terrain.pieces[piece].curve, state.position);
            double const gap = nearest.distance - radius;
            bool const at_left = left.feature >= 0 && t == 0 && gap <= touch_reach;
            if (gap <= (t == 0 ? touch_reach : gap_accuracy)) {
                Vec2 const normal = (state.position - nearest.point) / nearest.distance;
                double const rate = dot(state.velocity, normal);
                bool const still = std::abs(rate) <= 1e-12 * speed;
                if (still ? !at_left && sweep.presses(piece, t, lifting / frequency) : rate < 0) {
                    first = {t, sweep.contact_with(piece, state)};
                    return;
                }
                double const bend = sweep.bending(piece, normal, state);
                double const hop = bend < 0 && rate > 0 ? -2 * rate / bend : never;
                if (t == 0 && hop < lifting / frequency) {
                    // So short a hop is a parabola to rounding; conservative steps would not see its end.
                    if (hop < first.time) first = {hop, sweep.contact_with(piece, state)};
                    return;
                }
                double const most = sweep.bound_near(piece, state);
                t += std::max(most > 0 ? rate / most : never, (t == 0 && bend >= 0 ? lifting : blink) / frequency);
                continue;
            }
            t += sweep.safe_time(piece, state);
        }
    });
    return first;
}

}  // namespace physics
