// Motion along a track under constant pressure: roll and slide, their change within a substep, rolling resistance.
#pragma once

#include "geometry/oscillator.h"
#include "physics/terrain.h"

namespace physics {

// What drives a ball along its track, per unit mass.
struct Drive {
    double push = 0;      // m/s^2, constant, along the track
    bool pulled = false;  // the drag spring acts as well, at `offset` from its target when the motion begins
    double offset = 0;    // m
    geometry::Oscillator spring;
    double pressure = 0;  // m/s^2, the normal force
    double inertia = 0.5;
    Material material;
};

struct Along {
    double way = 0;     // m, since the motion began
    double speed = 0;   // m/s
    double rim = 0;     // m/s, -r times the spin: equal to the speed when rolling
    double rolled = 0;  // m, of the rim since the motion began: -r times the angle turned
};

// Exact for a constant push; with a spring the moments at which slip or motion end are those of a steady change.
Along after_moving(Drive const& drive, Along const& start, double time);

// Slip below this share of the speeds is rounding.
inline constexpr double no_slip = 1e-9;
bool slips(Along const& along);

}  // namespace physics
