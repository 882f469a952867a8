// The exact method: every leg is the closed form of its motion, and time goes from event to event. Right to rounding
// error whatever the times at which one asks, and no time is spent between events.
#pragma once

#include "physics/world/world.h"

namespace physics {

// Where balls rest on each other, or events crowd beyond any use, how balls meet is left to Steps with these numbers
// until no two are near each other any more: whoever leans meanwhile is stepped, whoever does not stays on its legs.
inline constexpr double handover_rate = 240;      // steps/s
inline constexpr double shortest_handover = 0.1;  // s, before balls are taken back
inline constexpr double takeover_gap = 0.02;      // of the smaller radius: balls nearer than this are not apart

struct Exact {};

void begin_with(Exact const&, Scene const& scene, World& world, History& history);
void advance_with(Exact const&, Scene const& scene, World& world, double until, History& history);
// From world.time on the forces are world.forces; before they were `before`.
void force_with(Exact const&, Scene const& scene, World& world, Forces const& before, History& history);

}  // namespace physics
