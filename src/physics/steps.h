// The stepping method: fixed steps of a few substeps, with friction, restitution, rolling inertia and balls that
// collide.
//
// A substep moves every ball by what holds for it: free balls and balls on one surface by the closed form of their
// motion (steps_travel.h, steps_ride.h), so that neither free flight nor rolling loses or gains; balls that lean on
// each other by soft constraints (steps_pile.h). What they run into on the way is found along the whole path, so
// nothing tunnels, and answered by impulses at the moment of touch (steps_impact.h, steps_pairs.h).
#pragma once

#include "physics/method.h"

namespace physics {

void advance_with(Steps const& method, Scene const& scene, World& world, double until, History& history);

}  // namespace physics
