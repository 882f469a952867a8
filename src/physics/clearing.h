// Clearings: a straight stretch of ground with nothing above it. A ball that bounces or rolls there again and again
// need not look round at every bounce and every joint.
#pragma once

#include <optional>

#include "physics/leg.h"
#include "physics/track_ends.h"

namespace physics {

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
struct Clearing {
    Contact contact;  // the piece that it was found from; feature -1: there is no clearing
    Track track;
    double low = 0, high = 0;  // m, free between
    double top = 0;            // m, free up to this height of the centre above its track

    int direction = 0;  // +1 or -1, in which a ball rolls
    Section here;       // where it is
};

// The clearing of a ball that has just bounced on a piece, if it comes down on it again.
Clearing clearing_of_hop(Terrain const& terrain, Ball const& ball, Contact contact, Ballistic const& flight,
                         double duration);

// A bounce and the flight after it.
struct Hop {
    State state;          // just after the bounce
    double duration = 0;  // s, until the ball comes down again
};
// The bounce at the end of a flight, if the next flight ends in the clearing as well and is one that can be seen.
std::optional<Hop> next_hop(Clearing const& clearing, Terrain const& terrain, Ball const& ball, Ballistic const& flight,
                            double duration);

// The clearing of a ball that rolls from place q of a piece to a joint, if the ground goes straight on there.
Clearing clearing_of_roll(Terrain const& terrain, Ball const& ball, Contact contact, double q, Ballistic const& roll);

// The next piece, and how the ball rolls along it.
struct Crossing {
    Section there;
    State state;  // at the joint
    TrackEnds ends;
    int towards = 0;      // +1 or -1: the end that the ball comes to
    double duration = 0;  // s, until then
};
// The crossing of the joint at the end of a roll, if the next piece is in the clearing and the ground goes straight on
// at its end.
std::optional<Crossing> next_crossing(Clearing const& clearing, Terrain const& terrain, Ball const& ball,
                                      Ballistic const& roll, double duration);

}  // namespace physics
