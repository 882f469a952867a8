#include "physics/ride.h"

#include <cmath>

#include "geometry/elementary.h"
#include "physics/course_track.h"

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
Rider rider_at(Setting const& setting, Leg const& leg, double span) {
    State const state = at_span(leg, span);
    Rider rider;
    rider.contact = leg.contact;
    rider.track = track_of(setting.terrain, leg.contact, setting.ball.radius);
    rider.q = coordinate_of(rider.track, leg, state, span);
    rider.speed = dot(state.velocity, geometry::turned_right(normal_at(rider.track, rider.q)));
    rider.rim = leg.phase == Phase::roll ? rider.speed : -setting.ball.radius * state.spin;
    rider.angle = state.angle;
    return rider;
}

Turnout fly(Setting const& setting, State const& state, double since) {
    Turnout turnout;
    turnout.course = flight_course(setting, state, since);
    return turnout;
}

Turnout ride_with(Setting const& setting, Rider const& rider, TrackEnds const& ends, Law const& law, double since) {
    Turnout turnout;
    turnout.ends = ends;
    turnout.course = law.phase == Phase::rest ? standing_course(state_of(setting, rider), rider.contact, 0, since)
                                              : track_course(setting, rider, law, ends, since);
    return turnout;
}

// On along the track, unless nothing presses the ball on it.
Turnout ride(Setting const& setting, Rider const& rider, TrackEnds const& ends, Onset onset, double since) {
    if (!is_pressed(setting, rider)) {
        Turnout turnout = fly(setting, state_of(setting, rider), since);
        turnout.happenings.push_back({EventKind::lift, rider.contact});
        return turnout;
    }
    Rider const held = held_by_full_grip(setting, rider);
    return ride_with(setting, held, ends, law_for(setting, held, onset), since);
}

Turnout ride_on_new_track(Setting const& setting, Rider const& rider, Onset onset, double since) {
    TrackEnds const ends = ends_of_track(setting.terrain, rider.contact, rider.track, rider.q, setting.ball.radius);
    return ride(setting, rider, ends, onset, since);
}

Turnout with_happening(Turnout turnout, EventKind kind, Contact contact) {
    turnout.happenings.insert(turnout.happenings.begin(), {kind, contact});
    return turnout;
}

// Over the gap that a convex joint leaves between two tracks, at most r times its turn: work done on the way is the
// field's, so that nothing is gained by going up.
void carry_over(Setting const& setting, Rider& rider, Vec2 const& from) {
    Vec2 const way = position_at(rider.track, rider.q) - from;
    if (geometry::length(way) <= touch_reach) return;
    double const inertia = rider.slip() == 0 ? 1 + setting.ball.inertia : 1;
    double const work = 2 * dot(acceleration_in(setting.field, from, Vec2::Zero()), way) / inertia;
    double const speed = std::copysign(std::sqrt(std::max(0.0, rider.speed * rider.speed + work)), rider.speed);
    if (rider.slip() == 0) rider.rim = speed;
    rider.speed = speed;
}

Turnout after_track(Setting const& setting, Leg const& leg, Outlook const& outlook) {
    Rider rider = rider_at(setting, leg, outlook.duration);
    Vec2 const from = position_at(rider.track, rider.q);
    rider.contact = outlook.next;
    rider.track = track_of(setting.terrain, outlook.next, setting.ball.radius);
    rider.q = outlook.next_q;
    carry_over(setting, rider, from);
    EventKind const kind = outlook.ending == Ending::joins ? EventKind::joint : EventKind::corner;
    return with_happening(ride_on_new_track(setting, rider, Onset::none, leg.until), kind, outlook.next);
}

Turnout after_stop(Setting const& setting, Leg const& leg, Outlook const& outlook) {
    Rider rider = rider_at(setting, leg, outlook.duration);
    rider.speed = rider.rim = 0;
    Turnout turnout = ride(setting, rider, outlook.ends, Onset::none, leg.until);
    if (turnout.course.leg.phase == Phase::rest) turnout = with_happening(turnout, EventKind::rest, leg.contact);
    return turnout;
}

Turnout after_settling(Setting const& setting, Leg const& leg, Outlook const& outlook) {
    Rider rider = rider_at(setting, leg, outlook.duration);
    if (std::abs(rider.slip()) <= ride_grip * (std::abs(rider.speed) + std::abs(rider.rim))) rider.rim = rider.speed;
    Turnout turnout = ride_on_new_track(setting, rider, Onset::none, leg.until);
    return with_happening(turnout, kind_of(turnout.course.leg.phase), leg.contact);
}

Turnout after_spin(Setting const& setting, Leg const& leg, Outlook const& outlook) {
    State state = at_span(leg, outlook.duration);
    state.spin = 0;
    Turnout turnout = resolved(setting, state, leg.until, leg.contact);
    if (turnout.course.leg.phase == Phase::roll) turnout = with_happening(turnout, EventKind::grip, leg.contact);
    return turnout;
}

Turnout after_search(Setting const& setting, Leg const& leg, Outlook const& outlook) {
    if (leg.phase != Phase::flight)
        return ride(setting, rider_at(setting, leg, outlook.duration), outlook.ends, outlook.onset, leg.until);
    Turnout turnout;
    turnout.course = continued_flight(setting, leg, outlook.duration);
    return turnout;
}

}  // namespace

Turnout after_end(Setting const& setting, Leg const& leg, Outlook const& outlook) {
    double const now = leg.until;
    switch (outlook.ending) {
        case Ending::none:
        case Ending::goes_on:
            return after_search(setting, leg, outlook);
        case Ending::meets:
            return resolved(setting, at_span(leg, outlook.duration), now, outlook.next);
        case Ending::joins:
        case Ending::turns:
            return after_track(setting, leg, outlook);
        case Ending::lifts:
            return with_happening(fly(setting, at_span(leg, outlook.duration), now), EventKind::lift, leg.contact);
        case Ending::slips:
            return with_happening(
                ride(setting, rider_at(setting, leg, outlook.duration), outlook.ends, outlook.onset, now),
                EventKind::slip, leg.contact);
        case Ending::grips: {
            Rider rider = rider_at(setting, leg, outlook.duration);
            rider.rim = rider.speed;
            return with_happening(ride(setting, rider, outlook.ends, Onset::none, now), EventKind::grip, leg.contact);
        }
        case Ending::stops:
            return after_stop(setting, leg, outlook);
        case Ending::settles:
            return after_settling(setting, leg, outlook);
        case Ending::spun_out:
            return after_spin(setting, leg, outlook);
    }
    return {};
}

Turnout under_new_field(Setting const& setting, Leg const& leg, Outlook const& outlook, double time) {
    bool const rides =
        leg.phase == Phase::roll || (leg.phase == Phase::slide && !std::holds_alternative<Ballistic>(leg.motion));
    if (rides) return ride(setting, rider_at(setting, leg, time - leg.since), outlook.ends, Onset::none, time);
    if (leg.phase == Phase::flight && leg.contact.feature < 0) return fly(setting, at(leg, time), time);
    return resolved(setting, at(leg, time), time, leg.contact);
}

}  // namespace physics
