// When two balls touch within a substep (physics.md 9.3).
#pragma once

#include "physics/steps/step_context.h"

namespace physics {

// The first moment, s into the substep, at which the two touch on their ways since they last departed, straight or leg
// by leg, and close faster than `least`, m/s; or `never`.
double time_of_touch(StepContext const& context, Substep const& substep, BallPair const& e, double least);

}  // namespace physics
