// The textbook's method: what most games that write their own physics do, to compare with. It shares nothing with the
// other methods but the terrain's curves and the way in which steps are written down.
//
// Once a step: velocities by the forces, then places by the new velocities (semi-implicit Euler); whoever overlaps then
// is given impulses with restitution and Coulomb friction, pair by pair, in a few sweeps; and is pushed out of what it
// overlaps (projection). So it errs by the first power of the step, turns what it pushes out into energy or loses it,
// and passes through what is thinner than its way in a step (physics.md 9.6). `auto` never picks it.
#pragma once

#include "physics/world/world.h"

namespace physics {

struct Euler {
    double rate = 240;  // steps/s
};

void advance_with(Euler const& method, Scene const& scene, World& world, double until, History& history);

}  // namespace physics
