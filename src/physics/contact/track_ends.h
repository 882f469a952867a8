// Track ends: what lies at the ends of a ball's track, and how far along it the ball can go.
#pragma once

#include "physics/contact/first_contact.h"
#include "physics/terrain/terrain.h"

namespace physics {

enum class EndKind {
    none,    // a closed circle has no ends
    joint,   // on to the smooth neighbour, or from a vertex to the piece beside it: the speed is kept
    corner,  // the surface turns away: the ball pivots round the vertex or takes off
    wall     // something else is in the way
};

struct TrackEnd {
    EndKind kind = EndKind::none;
    double q = 0;       // m, where on this track
    Contact next;       // whom the ball meets there
    double next_q = 0;  // m, where on the next track (joint, corner)
};

struct TrackEnds {
    TrackEnd low, high;  // towards smaller and greater q
};

// How far a ball of this radius can follow its track from q. What is in the way farther off than `reach` (m) may be left
// out.
TrackEnds ends_of_track(Terrain const& terrain, Contact contact, Track const& track, double q, double radius,
                        double reach = never);

}  // namespace physics
