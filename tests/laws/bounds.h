// Which method is bound to which law, and how closely: one table, so that a new method is bound by adding its rows.
#pragma once

#include <vector>

#include "physics/method.h"

namespace laws {

enum class Law {
    flight,              // parabola, spin kept
    roll_on_slope,       // physics.md 2.3
    slide_on_slope,      // 2.4
    slip_to_roll,        // 2.4
    spin_down,           // 2.4
    rolling_resistance,  // 2.5
    swing_in_valley,     // 2.6, period
    energy_in_valley,    // 2.6
    lift_off,            // 2.6, angle in degrees
    loop,                // 2.6, share of the threshold speed
    bend,                // T2, share of the speed lost
    hill,                // T3
    flat_joints,         // T8, height in m and share of the speed
    corner,              // 2.11, T9
    vertex,              // 2.10
    bounce,              // T10, share of the height
    impact_energy,       // T1
    pair_momentum,       // 1
    drag_in_air,         // 2.2, T5
    drag_on_ground,      // 2.3
    groove,              // 2.12
    path_of_centre,      // 1b, the angle rolled
};

struct Bound {
    physics::Method method;
    double tolerance = 0;  // in the law's own measure
};

// The methods bound to a law, each with its tolerance.
std::vector<Bound> bounds_of(Law law);

}  // namespace laws
