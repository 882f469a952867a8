// The exact method: every leg is the closed form of its motion, and time goes from event to event. Right to rounding
// error whatever the times at which one asks, and no time is spent between events.
#pragma once

#include "physics/method.h"

namespace physics {

// Where balls rest on each other, or events crowd beyond any use, the world is handed over to Steps with these numbers
// and taken back when the balls are apart again.
inline constexpr double handover_rate = 240;      // steps/s
inline constexpr double shortest_handover = 0.1;  // s, before the world is taken back
inline constexpr double takeover_gap = 0.02;      // of the smaller radius: balls nearer than this are not apart
inline constexpr double watch_span = 1e-3;        // s; more events than
inline constexpr int watch_events = 1000;  // these in that span for one ball hand the world over (physics.md 3.4)

// A lone ball is never handed over. Bounces on one surface under gravity alone have a limit, to which they are summed;
// others, between two surfaces, under the pull of the spring or where all but nothing is lost, end where they crowd: after so many of them within
// watch_span nothing bounces back. Where more events than stall_events fall in stall_span, the ball creeps on (ride.h).
inline constexpr int crowd_events = 50;
inline constexpr double most_summed = 0.9999;  // restitution: above it a sum of bounces counts as endless
inline constexpr double stall_span = 1e-10;  // s
inline constexpr int stall_events = 40;
inline constexpr int creep_events = 50;  // more within watch_span, and the ball stands until the forces change

void begin_with(Exact const&, Scene const& scene, World& world, History& history);
void advance_with(Exact const&, Scene const& scene, World& world, double until, History& history);
// From world.time on the forces are world.forces; before they were `before`.
void force_with(Exact const&, Scene const& scene, World& world, Forces const& before, History& history);

// One ball of a world, whatever becomes of the others: for methods that leave balls on their plan as long as none is
// near. It sets out at `time` (s) from a state, or, on its plan, is given another by a hit ...
void set_out(Scene const& scene, World& world, History& history, int ball, State const& state, Contact known,
             double time);
void strike(Scene const& scene, World& world, History& history, int ball, State const& state, double time);
// ... comes to `until` by its events up to then ...
void follow_plan(Scene const& scene, World& world, History& history, int ball, double until);
// ... and is moved by world.forces from `time` on, by others before.
void change_field(Scene const& scene, World& world, History& history, int ball, double time);

}  // namespace physics
