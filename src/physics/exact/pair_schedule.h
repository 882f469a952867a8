// The schedule of pairs: which balls meet first, kept in the plans of both.
#pragma once

#include <span>
#include <vector>

#include "physics/exact/time_of_impact.h"

namespace physics {

// Events of different balls nearer than this count as one moment.
inline constexpr double moment = 1e-12;  // s

// Whom the touched balls meet first from world.time on, and whom those meet that would have met one of them.
void schedule_hits(Scene const& scene, World& world, std::span<int const> touched);

// The pairs that strike at this moment, given where the balls are. A ball looks out for one other only: whoever else
// touches it as it is hit takes part in the blow.
std::vector<Pair> closing_pairs(Scene const& scene, World const& world, std::vector<State> const& states);

}  // namespace physics
