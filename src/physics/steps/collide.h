// What balls do to each other within a substep, after they have moved (physics.md 9.1, 9.3).
#pragma once

#include "physics/steps/step_context.h"

namespace physics {

// Impacts between balls within the substep, each at its moment: both go back to it, hit, and travel on. Pairs that
// close too slowly to bounce begin to lean on each other; those that part no longer do; what overlaps deep is parted.
void collide(StepContext& context, Substep const& substep);

}  // namespace physics
