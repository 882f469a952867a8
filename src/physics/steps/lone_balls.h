// Balls between their plan and the steps: who leans on nobody goes on by its plan (planned_balls.h), who leans goes
// from step to step in straight lines.
#pragma once

#include "physics/steps/step_context.h"

namespace physics {

inline bool is_stepped(World const& world, int ball) {
    return std::holds_alternative<Straight>(world.legs[ball].motion);
}

// At rest until something else moves it.
inline bool stands_for_ever(Leg const& leg) { return leg.phase == Phase::rest && leg.until == never; }

// On to the moment, on its plan.
void follow(StepContext& context, int ball, double time);

// From `time` on the ball, which is where its body state is, is stepped.
void begin_chord(StepContext& context, int ball, double time);

// The straight line ends, where its body state is now.
void end_chord(StepContext& context, int ball, double time);

// The present path of the ball begins `time` seconds into the substep, which ends at `until`, s; and goes back there.
void depart(StepContext& context, int ball, double time, double until);
void return_to_departure(StepContext& context, int ball);

// From `time` on a ball that was stepped is on its plan again. Soft contacts leave it a little inside of the terrain:
// it is put on its surface, and what that raises it is taken from its speed, so that no energy is gained.
void release(Scene const& scene, World& world, History& history, int ball, double time);

// Moves a stepped ball by `span` seconds as if it were alone, so that it meets all that is on its way.
void sweep(StepContext& context, int ball, double time, double span);

}  // namespace physics
