// Which method is bound to which law, and how closely: one table, so that a new method is bound by adding its rows.
// T1 to T20 are the failures that every method is tested for; README.md here lists them.
#pragma once

#include <vector>

#include "physics/method.h"

namespace laws {

enum class Law {
    flight,              // parabola, spin kept
    roll_on_slope,       // physics.md 3.3, T1
    slide_on_slope,      // physics.md 3.3
    slip_to_roll,        // physics.md 3.3
    spin_down,           // physics.md 3.3
    rolling_resistance,  // physics.md 4.2
    swing_in_valley,     // physics.md 3.7, period
    energy_in_valley,    // physics.md 3.5
    lift_off,            // physics.md 3.5, angle in degrees
    loop,                // physics.md 3.5, share of the threshold speed
    bend,                // T2, share of the speed lost
    hill,                // T3
    flat_joints,         // T8, height in m and share of the speed
    corner,              // physics.md 5.4, T9
    vertex,              // physics.md 5.3, T3
    bounce,              // T10, share of the height
    rest_time,           // T11
    impact_energy,       // T1
    pair_momentum,       // physics.md 1.3
    drag_in_air,         // physics.md 3.2, T4 and T5, m for a swing of 1 m
    drag_on_ground,      // physics.md 3.4, T4
    groove,              // physics.md 7.2
    path_of_centre,      // physics.md 2.2, the angle rolled
    no_escape,           // T6, m into a line
    rest,                // T12, m/s
    piles,               // T13 and T14: share of the overlap of soft contacts
    far_away,            // T15, radii off the path at the origin, 1e5 m away
    lawful_input,        // T16
    late_frame,          // T17
    hour,                // T18
    simultaneous,        // T19
};

struct Bound {
    physics::Method method;
    double tolerance = 0;  // in the law's own measure
};

// The methods bound to a law, each with its tolerance.
std::vector<Bound> bounds_of(Law law);

}  // namespace laws
