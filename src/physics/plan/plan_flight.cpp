// Flight: a parabola, or a damped swing about the drag spring's equilibrium, up to the first terrain.
#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "physics/plan/leg_plan.h"

namespace physics {

namespace {

// How far ahead a flight on the spring is searched at a time, in periods of the spring.
constexpr double search_periods = 0.25;

// A swing that does not gain never leaves its envelopes about the equilibrium: whatever lies outside it never meets.
bool swings_clear(MotionContext const& context, Leg const& leg, double searched) {
    auto const& flight = std::get<SpringFlight>(leg.motion);
    State const now = at_span(leg, searched);
    Vec2 const away = now.position - flight.equilibrium;
    Vec2 const reach(envelope(flight.oscillator, {away.x(), now.velocity.x()}),
                     envelope(flight.oscillator, {away.y(), now.velocity.y()}));
    double const rim = context.ball.radius + touch_reach;
    return !context.terrain.tree.overlaps_any(
        geometry::grown({flight.equilibrium - reach, flight.equilibrium + reach}, rim));
}

bool at_rest_for_good(Leg const& leg, double t) {
    State const now = at_span(leg, t);
    return geometry::length(now.velocity) == 0 && acceleration_bound(leg, leg.since + t, leg.since + t) == 0;
}

}  // namespace

LegPlan continue_flight(MotionContext const& context, Leg const& leg, double searched) {
    LegPlan plan;
    plan.leg = leg;
    double const window = search_periods * 2 * geometry::pi / std::sqrt(context.field.spring.stiffness);
    if (swings_clear(context, leg, searched) || at_rest_for_good(leg, searched)) {
        plan.leg.until = never;
        return plan;
    }
    SweepHit const found = first_contact(context.terrain, std::get<SpringFlight>(leg.motion), context.ball.radius,
                                         searched, searched + window);
    plan.end.time = found.time;
    plan.leg.until = leg.since + plan.end.time;
    plan.end.cause = found.contact.feature >= 0 ? LegEndCause::meets : LegEndCause::goes_on;
    plan.end.next = found.contact;
    return plan;
}

LegPlan plan_flight(MotionContext const& context, State const& state, double since) {
    LegPlan plan;
    plan.leg.since = since;
    if (context.field.pulled) {
        Vec2 const equilibrium = context.field.target + context.field.gravity / context.field.spring.stiffness;
        plan.leg.motion = SpringFlight{state, equilibrium, context.field.spring};
        return continue_flight(context, plan.leg, 0);
    }
    plan.leg.motion = Ballistic{state, context.field.gravity, 0};
    Parabola const path{state.position, state.velocity, context.field.gravity};
    SweepHit const found = first_contact(context.terrain, path, context.ball.radius, never, -1, context.horizon);
    plan.end.time = found.time;
    plan.leg.until = since + found.time;
    plan.end.cause = found.time < never ? LegEndCause::meets : LegEndCause::none;
    plan.end.next = found.contact;
    return plan;
}

}  // namespace physics
