// Outlooks: what the exact method knows of each ball's future, kept in the world from one call to the next.
#pragma once

#include "physics/clearing.h"

namespace physics {

// What ends a leg.
enum class Ending {
    none,     // nothing does
    goes_on,  // the same motion under a new expansion, or with another couple of rolling resistance
    meets,    // terrain: from flight, or a wall on the track
    joins,    // the smooth neighbour takes over
    turns,    // a corner: the vertex takes over
    lifts,    // no normal force is left
    slips,    // grip is lost
    grips,    // slip has ended
    stops,    // rolling resistance has stopped the ball
    settles,  // the last of infinitely many bounces
    spun_out  // the spin of a wedged ball has ended
};

// What is known of the moment just after an event that the speeds alone, equal at the limit, do not tell.
enum class Onset { none, slipping_forwards, slipping_backwards, resisting_fully, resisting_at_the_limit };

struct Outlook {
    Ending ending = Ending::none;
    double duration = never;  // s, from leg.since to leg.until, without the rounding of times far from 0
    Contact next;             // meets, joins, turns
    double next_q = 0;        // m, on the next track
    Onset onset = Onset::none;
    TrackEnds ends;     // of the track the ball is on
    Clearing clearing;  // on or above which it hops or rolls, if known

    double hit_time = never;  // s, the first meeting with another ball, or until when none was found
    int hit_ball = -1;        // -1: look again at hit_time

    double watch_since = 0;  // s, events are counted from here
    int watch_count = 0;
    Contact watch_contact;       // the first that was met, and whether
    bool watch_mixed = false;    // others were, or
    bool watch_elastic = false;  // one that loses all but nothing
    double stall_since = 0;  // s, the same
    int stall_count = 0;
    double creep_since = 0;  // s, the same of creeping
    int creep_count = 0;
};

}  // namespace physics
