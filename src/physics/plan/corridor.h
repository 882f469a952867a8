// Corridors: a straight stretch of ground with nothing above it. A ball that bounces or rolls there again and again
// need not look round at every bounce and every joint.
#pragma once

#include <optional>

#include "physics/world/ball_plan.h"

namespace physics {

// The corridor of a ball that has just bounced on a piece, if it comes down on it again.
Corridor corridor_of_hop(Terrain const& terrain, Ball const& ball, Contact contact, Ballistic const& flight,
                         double duration);

// A bounce and the flight after it.
struct Hop {
    State state;          // just after the bounce
    double duration = 0;  // s, until the ball comes down again
};
// The bounce at the end of a flight, if the next flight ends in the corridor as well and is one that can be seen.
std::optional<Hop> next_hop(Corridor const& corridor, Terrain const& terrain, Ball const& ball, Ballistic const& flight,
                            double duration);

// The corridor of a ball that rolls from place q of a piece to a joint, if the ground goes straight on there.
Corridor corridor_of_roll(Terrain const& terrain, Ball const& ball, Contact contact, double q, Ballistic const& roll);

// The next piece, and how the ball rolls along it.
struct Crossing {
    Section there;
    State state;  // at the joint
    TrackEnds ends;
    int towards = 0;      // +1 or -1: the end that the ball comes to
    double duration = 0;  // s, until then
};
// The crossing of the joint at the end of a roll, if the next piece is in the corridor and the ground goes straight on
// at its end.
std::optional<Crossing> next_crossing(Corridor const& corridor, Terrain const& terrain, Ball const& ball,
                                      Ballistic const& roll, double duration);

}  // namespace physics
