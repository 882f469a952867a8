// What neither hits one by one nor soft contacts hold: balls that crowd, or that are pressed deep into each other, are
// stopped together by impulses that are found at once, whatever their masses.
#pragma once

#include "physics/steps/step_context.h"

namespace physics {

// Overlaps deeper than this share of the (smaller) radius are pushed back to it at once.
inline constexpr double deepest = 0.05;
// What is just there is left alone.
inline constexpr double too_deep = deepest * (1 + 1e-3);

// The balls about a pair that goes on hitting at `time` within the substep, without end as far as that was followed:
// from there on none of them closes on another or on terrain.
void stop_crowd(StepContext& context, Substep const& substep, int pair, double time);

// Likewise about two balls, or a ball (twice) and terrain, that overlap too deep at the substep's end; and they are
// moved apart.
void part_deep(StepContext& context, Substep const& substep, int ball, int other);

}  // namespace physics
