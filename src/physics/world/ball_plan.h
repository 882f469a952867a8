// Plans: what is known of each ball's future, kept in the world from one call to the next.
#pragma once

#include "physics/contact/track_ends.h"
#include "physics/motion/leg.h"

namespace physics {

// What ends a leg.
enum class LegEndCause {
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
enum class ModeHint {
    none,
    slipping_forwards,
    slipping_backwards,
    resisting_fully,
    resisting_at_the_limit,
    pulled_forwards,  // rolling against a resistance beyond what grip carries
    pulled_backwards
};

// How a leg ends, as far as is known.
struct LegEnd {
    double time = never;  // s since the leg began, without the rounding of times far from 0
    LegEndCause cause = LegEndCause::none;
    Contact next;       // meets, joins, turns
    double next_q = 0;  // m, on the next track: joins, turns
    ModeHint hint = ModeHint::none;
};

// A joint at which the ground goes straight on, of the same material.
struct Junction {
    Contact next;
    double length = 0;  // m, of the next piece
};

// The piece that a rolling ball is on.
struct Section {
    Contact contact;
    double begin = 0;   // m, the place where it begins
    double length = 0;  // m
    Junction ahead;     // at its end
};

// Places are those of the ball's centre: m along the track of the piece that the ball was on when it looked round.
struct Corridor {
    Contact contact;  // the piece that it was found from; feature -1: there is no corridor
    Track track;
    double low = 0, high = 0;  // m, free between
    double top = 0;            // m, free up to this height of the centre above its track

    int direction = 0;  // +1 or -1, in which a ball rolls
    Section here;       // where it is
};

// Events counted from a time on.
struct Tally {
    double since = 0;  // s
    int count = 0;
};

struct BallPlan {
    LegEnd end;            // of the current leg
    TrackEnds track_ends;  // of the track the ball is on
    Corridor corridor;     // on or above which it hops or rolls, if known

    double hit_time = never;  // s, the first meeting with another ball, or until when none was found
    int hit_ball = -1;        // -1: look again at hit_time

    Tally watch, frame;          // of what it met, within two spans (planned_balls.h)
    Contact watch_contact;       // the first that was met since watch.since, and whether
    bool watch_mixed = false;    // others were, or a socket, or
    bool watch_elastic = false;  // one that loses all but nothing
    Tally stall, flips, creeps;  // of all at one moment, of changes between contact modes, of creeping
    double jammed_at = -never;   // s, when creeping last took it nowhere
};

}  // namespace physics
