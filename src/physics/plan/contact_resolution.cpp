// What becomes of a ball where it touches terrain: impacts, then which contacts it keeps.
#include <algorithm>
#include <cmath>

#include "physics/plan/plan_track.h"
#include "physics/plan/struck.h"

namespace physics {

using geometry::dot;

namespace {

// Rounding of accelerations, times this, tells a gap that opens.
constexpr double parting = 1e3;

}  // namespace

SurfaceState surface_state_on(MotionContext const& context, Struck const& struck, std::size_t i) {
    ContactPoint const& point = struck.points[i];
    ContactSpeeds const speeds = speeds_at(context, struck.state, point.normal);
    SurfaceState on_track;
    on_track.contact = point.contact;
    on_track.track = track_of(context.terrain, point.contact, context.ball.radius);
    on_track.q = nearest_coordinate(on_track.track, struck.state.position);
    on_track.speed = std::abs(speeds.tangent) <= struck.rounding ? 0 : speeds.tangent;
    on_track.rim =
        std::abs(speeds.slip()) <= struck.rounding || struck.gripped == point.normal ? on_track.speed : speeds.rim;
    on_track.angle = struck.state.angle;
    return on_track;
}

namespace {

// How fast the ball leaves the support, if so slowly that its bounces are summed (physics.md 6.2); nothing if it
// flies.
std::optional<double> hop_on(MotionContext const& context, Struck const& struck, std::size_t i) {
    double const normal_speed = dot(struck.state.velocity, struck.points[i].normal);
    if (normal_speed <= struck.still) return 0;
    if (!fits(context.terrain, struck.points[i].contact, context.ball.radius)) {
        if (normal_speed <= sway_speed(context, struck.state)) return 0;
        return std::nullopt;
    }
    // What drives a ball against the end of its track may be friction, of which the pressing field does not tell.
    bool const known = struck.points[i].contact == struck.known;
    if (known && struck.blows.empty() && normal_speed <= sway_speed(context, struck.state)) return 0;
    SurfaceState const on_track = surface_state_on(context, struck, i);
    double const pressing = normal_force(context, on_track);
    bool const sums = sums_exactly(context, on_track, normal_speed);
    double const lowest = sums ? lowest_hop_of_sums : lowest_hop;
    if (normal_speed * normal_speed < 2 * pressing * lowest * context.ball.radius) return normal_speed;
    if (context.many && 2 * normal_speed < pressing * longest_of_many) return sums ? normal_speed : 0;
    return std::nullopt;
}

// Whether a moving ball is carried off the support by its way alone, as past a point.
bool parts(MotionContext const& context, Struck const& struck, std::size_t i, Vec2 const& pull) {
    double const square = struck.state.velocity.squaredNorm();
    double const rounding = bend_rounding + place_rounding(struck.state.position, context.ball.radius);
    return square > struck.rounding * struck.rounding &&
           second_derivative(struck.points[i], struck.state.velocity, pull) >
               parting * rounding * (geometry::length(pull) + square / context.ball.radius);
}

// m, how far a ball on its track can get within the horizon: friction drives it at most as fast as its rim, gravity
// adds to that.
double farthest_on_track(MotionContext const& context, SurfaceState const& on_track) {
    if (context.horizon == never || context.field.pulled) return never;
    double const speed = std::max(std::abs(on_track.speed), std::abs(on_track.rim));
    return 2 * context.horizon * (speed + context.horizon * geometry::length(context.field.gravity));
}

}  // namespace

Transition ride_from(MotionContext const& context, SurfaceState const& free_state, double time) {
    Transition transition;
    // Full grip slows a ball that slips: what its way pressed on before may press no more.
    SurfaceState const on_track = is_pressed(context, free_state) ? held_by_full_grip(context, free_state) : free_state;
    if (!is_pressed(context, on_track)) {
        transition.plan = plan_flight(context, state_of(context, on_track), time);
        transition.contact_events.push_back({EventKind::lift, on_track.contact});
        return transition;
    }
    ContactMode const mode = contact_mode_for(context, on_track, ModeHint::none);
    transition.track_ends = ends_of_track(context.terrain, on_track.contact, on_track.track, on_track.q,
                                          context.ball.radius, farthest_on_track(context, on_track));
    transition.plan = mode.phase == Phase::rest ? plan_standing(state_of(context, on_track), on_track.contact, 0, time)
                                                : plan_track(context, on_track, mode, transition.track_ends, time);
    if (mode.phase == Phase::rest) transition.contact_events.push_back({EventKind::rest, on_track.contact});
    return transition;
}

namespace {

// Whether the sum of bounces, which goes straight, stays on the track: it ends before the track does, in either
// direction and with room to spare, and has not strayed from its curve.
bool keeps_to_track(MotionContext const& context, SurfaceState const& on_track, LegPlan const& plan) {
    auto const& motion = std::get<Ballistic>(plan.leg.motion);
    double const way = plan.end.time *
                       (geometry::length(motion.from.velocity) + plan.end.time * geometry::length(motion.acceleration));
    if (way == 0) return true;
    if (!on_track.track.straight && way * way > 2 * on_track.track.rho * least_depth) return false;
    TrackEnds const ends =
        ends_of_track(context.terrain, on_track.contact, on_track.track, on_track.q, context.ball.radius);
    return on_track.q - 2 * way > ends.low.q && on_track.q + 2 * way < ends.high.q;
}

Transition kept_transition(MotionContext const& context, Struck& struck, std::vector<std::size_t> const& kept,
                           double time) {
    if (kept.size() > 1) return among_several(context, struck, kept, time);
    if (!fits(context.terrain, struck.points[kept.front()].contact, context.ball.radius)) {
        auto const held = wedged(context, struck, kept, time);
        return held ? *held : stuck(context, struck, kept, time);
    }
    double const hop = *hop_on(context, struck, kept.front());
    SurfaceState const on_track = surface_state_on(context, struck, kept.front());
    if (hop == 0) return ride_from(context, on_track, time);
    Transition transition;
    transition.plan = plan_settling(context, on_track, hop, time);
    if (keeps_to_track(context, on_track, transition.plan)) return transition;
    // Where it would run off or into something before the last bounce, it bounces on, or, if that is not seen, rides.
    bool const seen = hop * hop >= 2 * normal_force(context, on_track) * lowest_hop * context.ball.radius;
    if (seen && !context.crowded && !context.many) {
        transition.plan = plan_flight(context, struck.state, time);
        return transition;
    }
    return ride_from(context, on_track, time);
}

}  // namespace

Transition resolved(MotionContext const& context, State const& state, double time, Contact known) {
    Struck struck = struck_at(context, state, known);
    strike_all(context, struck);
    if (geometry::length(struck.state.velocity) <= struck.rounding) struck.state.velocity = Vec2::Zero();
    choose_supports(context, struck);
    Vec2 const pull = acceleration_in(context.field, struck.state.position, struck.state.velocity);
    if (stands_among_several(context, struck)) struck.state.velocity = Vec2::Zero();
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < struck.points.size(); ++i)
        if (!is_left_behind(struck.points[i], struck.state.velocity, pull, struck.rounding) &&
            !parts(context, struck, i, pull) && hop_on(context, struck, i))
            kept.push_back(i);
    Transition transition;
    if (kept.empty())
        transition.plan = plan_flight(context, struck.state, time);
    else
        transition = kept_transition(context, struck, kept, time);
    // The first of the bounces that are summed is told with their end.
    if (transition.plan.end.cause != LegEndCause::settles)
        transition.contact_events.insert(transition.contact_events.begin(), struck.blows.begin(), struck.blows.end());
    return transition;
}

}  // namespace physics
