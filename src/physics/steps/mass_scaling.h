// Light balls beneath heavy ones: what the soft contacts of a pile cannot hold by themselves (physics.md 9.4).
#pragma once

#include "physics/steps/step_context.h"

namespace physics {

// To 1, by which a ball may outweigh one that it leans on, for a warm start of one round in a substep to settle.
inline constexpr double most_outweigh = 400;

// Hz, of soft contacts between balls at so many substeps a second.
double contact_frequency(double substeps_per_second);

// Takes each leaning ball for so much heavier (a power of two, so that no bit is lost) that the heaviest one that hangs
// together with it outweighs it by no more than soft contacts carry at a small overlap: 400 times, less for small
// balls. Only while they lean: hits know the masses as they are.
void swell_light_balls(StepContext& context);

}  // namespace physics
