#include "physics/plan/transition.h"

#include <cmath>

#include "geometry/elementary.h"
#include "physics/plan/plan_track.h"

namespace physics {

using geometry::dot;

namespace {

// Slip below this share of the speeds is rounding: the ball grips.
constexpr double ride_grip = 1e-12;

// A closed circle is run round more than once: q goes on counting.
double coordinate_of(Track const& track, Leg const& leg, State const& state, double span) {
    auto const phi = polar_angle_at(leg.motion, span);
    if (!track.closed || !phi) return nearest_coordinate(track, state.position);
    return (track.phi0 - *phi) * track.rho * track.sense;
}

// `span` seconds after the leg began.
SurfaceState surface_state_at(MotionContext const& context, Leg const& leg, double span) {
    State const state = at_span(leg, span);
    SurfaceState on_track;
    on_track.contact = leg.contact;
    on_track.track = track_of(context.terrain, leg.contact, context.ball.radius);
    on_track.q = coordinate_of(on_track.track, leg, state, span);
    on_track.speed = dot(state.velocity, geometry::turned_right(normal_at(on_track.track, on_track.q)));
    on_track.rim = leg.phase == Phase::roll ? on_track.speed : -context.ball.radius * state.spin;
    on_track.angle = state.angle;
    return on_track;
}

Transition fly(MotionContext const& context, State const& state, double since) {
    Transition transition;
    transition.plan = plan_flight(context, state, since);
    return transition;
}

Transition ride_with(MotionContext const& context, SurfaceState const& on_track, TrackEnds const& ends,
                     ContactMode const& mode, double since) {
    Transition transition;
    transition.track_ends = ends;
    transition.plan = mode.phase == Phase::rest ? plan_standing(state_of(context, on_track), on_track.contact, 0, since)
                                                : plan_track(context, on_track, mode, ends, since);
    return transition;
}

// On along the track, unless nothing presses the ball on it.
Transition ride(MotionContext const& context, SurfaceState const& on_track, TrackEnds const& ends, ModeHint hint,
                double since) {
    if (!is_pressed(context, on_track)) {
        Transition transition = fly(context, state_of(context, on_track), since);
        transition.contact_events.push_back({EventKind::lift, on_track.contact});
        return transition;
    }
    SurfaceState const held = held_by_full_grip(context, on_track);
    return ride_with(context, held, ends, contact_mode_for(context, held, hint), since);
}

Transition ride_on_new_track(MotionContext const& context, SurfaceState const& on_track, ModeHint hint, double since) {
    TrackEnds const ends =
        ends_of_track(context.terrain, on_track.contact, on_track.track, on_track.q, context.ball.radius);
    return ride(context, on_track, ends, hint, since);
}

Transition with_event(Transition transition, EventKind kind, Contact contact) {
    transition.contact_events.insert(transition.contact_events.begin(), {kind, contact});
    return transition;
}

// Over the gap that a convex joint leaves between two tracks, at most r times its turn: work done on the way is the
// field's, so that nothing is gained by going up.
void carry_over(MotionContext const& context, SurfaceState& on_track, Vec2 const& from) {
    Vec2 const way = position_at(on_track.track, on_track.q) - from;
    if (geometry::length(way) <= touch_reach) return;
    double const inertia = on_track.slip() == 0 ? 1 + context.ball.inertia : 1;
    double const work = 2 * dot(acceleration_in(context.field, from, Vec2::Zero()), way) / inertia;
    double const speed =
        std::copysign(std::sqrt(std::max(0.0, on_track.speed * on_track.speed + work)), on_track.speed);
    if (on_track.slip() == 0) on_track.rim = speed;
    on_track.speed = speed;
}

Transition after_track(MotionContext const& context, Leg const& leg, BallPlan const& plan) {
    SurfaceState on_track = surface_state_at(context, leg, plan.end.time);
    Vec2 const from = position_at(on_track.track, on_track.q);
    on_track.contact = plan.end.next;
    on_track.track = track_of(context.terrain, plan.end.next, context.ball.radius);
    on_track.q = plan.end.next_q;
    carry_over(context, on_track, from);
    EventKind const kind = plan.end.cause == LegEndCause::joins ? EventKind::joint : EventKind::corner;
    return with_event(ride_on_new_track(context, on_track, ModeHint::none, leg.until), kind, plan.end.next);
}

Transition after_stop(MotionContext const& context, Leg const& leg, BallPlan const& plan) {
    SurfaceState on_track = surface_state_at(context, leg, plan.end.time);
    on_track.speed = on_track.rim = 0;
    Transition transition = ride(context, on_track, plan.track_ends, ModeHint::none, leg.until);
    if (transition.plan.leg.phase == Phase::rest) transition = with_event(transition, EventKind::rest, leg.contact);
    return transition;
}

Transition after_settling(MotionContext const& context, Leg const& leg, BallPlan const& plan) {
    SurfaceState on_track = surface_state_at(context, leg, plan.end.time);
    if (std::abs(on_track.slip()) <= ride_grip * (std::abs(on_track.speed) + std::abs(on_track.rim)))
        on_track.rim = on_track.speed;
    Transition transition = ride_on_new_track(context, on_track, ModeHint::none, leg.until);
    return with_event(transition, kind_of(transition.plan.leg.phase), leg.contact);
}

Transition after_spin(MotionContext const& context, Leg const& leg, BallPlan const& plan) {
    State state = at_span(leg, plan.end.time);
    state.spin = 0;
    Transition transition = resolved(context, state, leg.until, leg.contact);
    if (transition.plan.leg.phase == Phase::roll) transition = with_event(transition, EventKind::grip, leg.contact);
    return transition;
}

Transition after_search(MotionContext const& context, Leg const& leg, BallPlan const& plan) {
    if (leg.phase != Phase::flight)
        return ride(context, surface_state_at(context, leg, plan.end.time), plan.track_ends, plan.end.hint, leg.until);
    Transition transition;
    transition.plan = continue_flight(context, leg, plan.end.time);
    return transition;
}

// Out of flight along the tangent of a surface a ball lands on it without a blow, or passes it.
Transition out_of_flight(Transition transition, Leg const& before) {
    Leg const& leg = transition.plan.leg;
    auto const& told = transition.contact_events;
    bool const flew = before.phase == Phase::flight && before.contact.feature < 0;
    if (flew && told.empty() && leg.phase != Phase::flight && transition.plan.end.cause != LegEndCause::settles)
        return with_event(transition, EventKind::land, leg.contact);
    if (flew && told.size() == 1 && told.front().kind == EventKind::lift) transition.contact_events.clear();
    return transition;
}

}  // namespace

Transition after_end(MotionContext const& context, Leg const& leg, BallPlan const& plan) {
    double const now = leg.until;
    switch (plan.end.cause) {
        case LegEndCause::none:
        case LegEndCause::goes_on:
            return after_search(context, leg, plan);
        case LegEndCause::meets:
            return out_of_flight(resolved(context, at_span(leg, plan.end.time), now, plan.end.next), leg);
        case LegEndCause::joins:
        case LegEndCause::turns:
            return after_track(context, leg, plan);
        case LegEndCause::lifts:
            return with_event(fly(context, at_span(leg, plan.end.time), now), EventKind::lift, leg.contact);
        case LegEndCause::slips:
            return with_event(
                ride(context, surface_state_at(context, leg, plan.end.time), plan.track_ends, plan.end.hint, now),
                EventKind::slip, leg.contact);
        case LegEndCause::grips: {
            SurfaceState on_track = surface_state_at(context, leg, plan.end.time);
            on_track.rim = on_track.speed;
            return with_event(ride(context, on_track, plan.track_ends, ModeHint::none, now), EventKind::grip,
                              leg.contact);
        }
        case LegEndCause::stops:
            return after_stop(context, leg, plan);
        case LegEndCause::settles:
            return after_settling(context, leg, plan);
        case LegEndCause::spun_out:
            return after_spin(context, leg, plan);
    }
    return {};
}

Transition under_new_field(MotionContext const& context, Leg const& leg, BallPlan const& plan, double time) {
    bool const rides =
        leg.phase == Phase::roll || (leg.phase == Phase::slide && !std::holds_alternative<Ballistic>(leg.motion));
    if (rides)
        return ride(context, surface_state_at(context, leg, time - leg.since), plan.track_ends, ModeHint::none, time);
    if (leg.phase == Phase::flight && leg.contact.feature < 0) return fly(context, at(leg, time), time);
    return resolved(context, at(leg, time), time, leg.contact);
}

}  // namespace physics
