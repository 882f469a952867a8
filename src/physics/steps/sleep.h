// Balls that have come to rest are left standing until something near them moves (physics.md 9.5).
#pragma once

#include "physics/steps/step_context.h"

namespace physics {

// Whether all balls are left standing, so that steps pass without work.
bool all_asleep(Scene const& scene, World const& world);

// Whom this step leaves standing. A ball wakes when one that it leans on moves, or presses on it otherwise than when it
// fell asleep.
void put_to_sleep(StepContext& context, double pace);

// Counts for how long each ball has stood, and stops those that fall asleep.
void count_still(StepContext& context, World& world);

}  // namespace physics
