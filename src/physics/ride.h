// Rides: how one ball goes on after an event: which contacts it keeps, in which phase, on which course.
#pragma once

#include <vector>

#include "physics/course.h"
#include "physics/world.h"

namespace physics {

// What a ball does next, and what happened to it on the way there.
struct Turnout {
    Course course;
    TrackEnds ends;  // of the track, when it is on one
    struct Happening {
        EventKind kind = EventKind::land;
        Contact contact;
    };
    std::vector<Happening> happenings;
};

// The event that begins a phase in contact.
inline EventKind kind_of(Phase phase) {
    return phase == Phase::rest ? EventKind::rest : phase == Phase::roll ? EventKind::grip : EventKind::slip;
}

// At the end of a leg, or of what has been searched of it.
Turnout after_end(Setting const& setting, Leg const& leg, Outlook const& outlook);

// At rest, in contact or in flight, in any state: blows with terrain that the ball closes on, then what it can keep.
// `struck` is the contact that the caller knows to be touched, or no_contact.
Turnout resolved(Setting const& setting, State const& state, double time, Contact struck);

// On from where events stall, a little way: the ball keeps to all that it touches, as if nothing there bounced or rubbed,
// for so short a time that it strays by less than `creep_stray`. What holds when two contacts are within rounding of each
// other in a way that no other rule foresees.
inline constexpr double creep_stray = 1e-11;  // m
Turnout creeping(Setting const& setting, State const& state, double time);

// Standing where it is, whatever pulls.
Turnout jammed(State const& state, Contact contact, double time);

// The same ball at `time` in the middle of a leg, after the field has changed.
Turnout under_new_field(Setting const& setting, Leg const& leg, Outlook const& outlook, double time);

}  // namespace physics
