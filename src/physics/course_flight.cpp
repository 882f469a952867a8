// Flight: a parabola, or a damped swing about the drag spring's equilibrium, up to the first terrain.
#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "physics/course.h"

namespace physics {

namespace {

// How far ahead a flight on the spring is searched at a time, in periods of the spring.
constexpr double search_periods = 0.25;

// A swing that does not gain never leaves its envelopes about the equilibrium: whatever lies outside it never meets.
bool swings_clear(Setting const& setting, Leg const& leg, double searched) {
    auto const& flight = std::get<SpringFlight>(leg.motion);
    State const now = at_span(leg, searched);
    Vec2 const away = now.position - flight.equilibrium;
    Vec2 const reach(envelope(flight.oscillator, {away.x(), now.velocity.x()}),
                     envelope(flight.oscillator, {away.y(), now.velocity.y()}));
    double const rim = setting.ball.radius + touch_reach;
    return !setting.terrain.tree.overlaps_any(
        geometry::grown({flight.equilibrium - reach, flight.equilibrium + reach}, rim));
}

bool at_rest_for_good(Leg const& leg, double t) {
    State const now = at_span(leg, t);
    return geometry::length(now.velocity) == 0 && acceleration_bound(leg, leg.since + t, leg.since + t) == 0;
}

}  // namespace

Course continued_flight(Setting const& setting, Leg const& leg, double searched) {
    Course course;
    course.leg = leg;
    double const window = search_periods * 2 * geometry::pi / std::sqrt(setting.field.spring.stiffness);
    if (swings_clear(setting, leg, searched) || at_rest_for_good(leg, searched)) {
        course.leg.until = never;
        return course;
    }
    Obstacle const found = first_contact(setting.terrain, std::get<SpringFlight>(leg.motion), setting.ball.radius, searched,
                                         searched + window);
    course.duration = found.time;
    course.leg.until = leg.since + course.duration;
    course.ending = found.contact.feature >= 0 ? Ending::meets : Ending::goes_on;
    course.next = found.contact;
    return course;
}

Course flight_course(Setting const& setting, State const& state, double since) {
    Course course;
    course.leg.since = since;
    if (setting.field.pulled) {
        Vec2 const equilibrium = setting.field.target + setting.field.gravity / setting.field.spring.stiffness;
        course.leg.motion = SpringFlight{state, equilibrium, setting.field.spring};
        return continued_flight(setting, course.leg, 0);
    }
    course.leg.motion = Ballistic{state, setting.field.gravity, 0};
    Parabola const path{state.position, state.velocity, setting.field.gravity};
    Obstacle const found = first_contact(setting.terrain, path, setting.ball.radius, never);
    course.duration = found.time;
    course.leg.until = since + found.time;
    course.ending = found.time < never ? Ending::meets : Ending::none;
    course.next = found.contact;
    return course;
}

}  // namespace physics
