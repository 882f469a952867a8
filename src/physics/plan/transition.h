// Transitions: how one ball goes on after an event: which contacts it keeps, in which phase, on which leg.
#pragma once

#include <vector>

#include "physics/plan/leg_plan.h"
#include "physics/world/world.h"

namespace physics {

// What a ball does next, and what happened to it on the way there.
struct Transition {
    LegPlan plan;
    TrackEnds track_ends;  // of the track, when it is on one
    struct ContactEvent {
        EventKind kind = EventKind::land;
        Contact contact;
    };
    std::vector<ContactEvent> contact_events;
};

// The event that begins a phase in contact.
inline EventKind kind_of(Phase phase) {
    return phase == Phase::rest ? EventKind::rest : phase == Phase::roll ? EventKind::grip : EventKind::slip;
}

// At the end of a leg, or of what has been searched of it.
Transition after_end(MotionContext const& context, Leg const& leg, BallPlan const& plan);

// At rest, in contact or in flight, in any state: blows with terrain that the ball closes on, then what it can keep.
// `struck` is the contact that the caller knows to be touched, or no_contact.
Transition resolved(MotionContext const& context, State const& state, double time, Contact struck);

// On from where events stall, a little way: the ball keeps to all that it touches, as if nothing there bounced or
// rubbed, for so short a time that it strays by less than `creep_stray`. What holds when two contacts are within
// rounding of each other in a way that no other rule foresees.
inline constexpr double creep_stray = 1e-11;  // m
Transition creeping(MotionContext const& context, State const& state, double time);

// Standing where it is, whatever pulls.
Transition jammed(State const& state, Contact contact, double time);

// The same ball at `time` in the middle of a leg, after the field has changed.
Transition under_new_field(MotionContext const& context, Leg const& leg, BallPlan const& plan, double time);

}  // namespace physics
