// The stepping method: balls that lean on each other take fixed steps of a few substeps, all others follow their plan
// (physics.md 9.1).
//
// How one ball moves against terrain is known once, as the legs (plan/planned_balls.h). A ball that no
// other can come near within a step is left to it. Those that have others near are looked at in substeps: on their plan
// too, they hit each other at the moment of touch (collide.cpp); once they press on each other they lean, by soft
// constraints, and go in a straight line from step to step, until they part (contact_island.h).
#pragma once

#include "physics/world/world.h"

namespace physics {

struct Steps {
    double rate = 240;  // steps/s
    int substeps = 4;
};

void begin_with(Steps const& method, Scene const& scene, World& world, History& history);
// To `until`; balls that have others near are settled to the end of the step.
void advance_with(Steps const& method, Scene const& scene, World& world, double until, History& history);
// Acts at world.time on balls that no other is near, on others from the next step on.
void force_with(Steps const& method, Scene const& scene, World& world, Forces const& before, History& history);

}  // namespace physics
