// Handing balls over from the exact method to the stepping one, and taking them back.
#pragma once

#include "physics/world/world.h"

namespace physics {

// From world.time on balls that are near each other take steps, counted from there, because of `ball` and those that it
// touches. Every ball stays on its plan until it leans on another, of that island or not.
void hand_over(Scene const& scene, World& world, int ball, History& history);

// To `until` or to the end of the present step, whichever is sooner. Balls that come to lean on others meanwhile are
// told to be handed over at its end.
void step_handed_over(Scene const& scene, World& world, double until, History& history);

// Whether no ball is near another any more, and the handover has lasted a while; at the end of a step.
bool is_apart(Scene const& scene, World const& world);

// All balls are on their plans again. What has still to be told of the steps is told.
void take_back(Scene const& scene, World& world, History& history);

}  // namespace physics
