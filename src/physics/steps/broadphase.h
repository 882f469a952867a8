// Balls among balls: who is near whom, and who is left standing (physics.md 9.1).
#pragma once

#include "physics/steps/step_context.h"

namespace physics {

// Pairs that may touch within the next `step` seconds, and who is alone; what is known of pairs is kept.
void find_neighbours(StepContext& context, double step);

// The same in the middle of a step, when impacts have sent these balls where nobody looked for them. Balls that are
// alone have had their step already: they are met in the next.
void find_more_neighbours(StepContext& context, std::vector<int> const& balls);

// For how long from `now` on it is certain that no ball comes near another; 0 s where that is not known.
double clear_span(StepContext const& context, double now);

// Who has no neighbours.
void mark_alone(StepContext& context);

// Sorts balls and pairs by what a substep does with them, if that has changed. Answers whether it had.
bool group(StepContext& context);

// Who leans on nobody any more is on its plan from `now` on, the beginning of a substep.
void release_parted(StepContext& context, double now);

// Contacts with terrain of the balls that are moved and of those asleep.
std::vector<CachedContact> all_touches(ContactIsland const& island);

void remember_departures(StepContext& context, double until);  // s, the end of the substep

}  // namespace physics
