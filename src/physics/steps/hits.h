// Hits of balls at a moment within the substep: back to it, the impulses, and on from it (physics.md 9.3).
#pragma once

#include <vector>

#include "physics/steps/step_context.h"

namespace physics {

// Where a ball is on its way since its last departure, `time` seconds into the substep: on its plan, or, if it is
// stepped, on the straight line to where it has come to.
Vec2 on_the_way(StepContext const& context, Substep const& substep, int ball, double time);

// How fast the two close on each other, m/s.
double closing_of(StepContext const& context, BallPair const& e);

// The way of the ball is not what it was: its pairs are to be looked at again.
void mark_struck(StepContext& context, int ball);

// Takes a ball back to `time` within the substep.
void go_back(StepContext& context, Substep const& substep, int ball, double time);

// Sends a ball on from there: on a new plan, or, if it leans, as a ball alone would go, with the ground's answer to
// what has just hit it.
void go_on(StepContext& context, Substep const& substep, int ball, double time);

// All these pairs touch and close at `time`, where their balls are now. One pair hits as mechanics says; of several
// that share balls none is the first: their impulses along the normals are found together, then friction. Pairs that
// close too slowly to bounce begin to lean on each other.
void hit(StepContext& context, Substep const& substep, std::vector<int> const& pairs, double time);

// Speeds below this share of those of the balls are rounding.
inline constexpr double unmoving = 1e-9;

}  // namespace physics
