// Balls among balls: who is near whom, and impacts between them at the moment of touch.
#pragma once

#include "physics/steps_stage.h"

namespace physics {

// Contacts kept from the step before, so that a resting pile starts where it was; and those to keep for the next.
void recall_touches(Stage& stage, std::vector<Touch> const& touches);
std::vector<Touch> touches_of(Stage const& stage);

// Pairs that may touch within the next step of `step` seconds, and who is alone; what is known of pairs is kept.
void find_encounters(Stage& stage, double step);

// The same in the middle of a step, when impacts have sent balls where nobody looked for them. Balls that are alone
// have had their step already: they are met in the next.
void find_more_encounters(Stage& stage, double rest);

// A standing ball wakes when one that it touches does, or when one comes to it.
void wake_neighbours(Stage& stage);

void remember_departures(Stage& stage);

// Which balls lean on others; false if none does.
bool mark_leaning(Stage& stage);

// Impacts between balls within the substep, each at its moment: both go back to it, hit, and travel on. Pairs that
// close too slowly to bounce begin to lean on each other.
void collide(Stage& stage, Substep const& substep);

}  // namespace physics
