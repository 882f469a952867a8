// Impacts of two balls: the impulse, with restitution and Coulomb friction (physics.md 1.3). It never gains energy.
#pragma once

#include "physics/motion/impact.h"
#include "physics/world/world.h"

namespace physics {

// The states of two balls just after they hit each other; `normal` points from the first to the second.
struct PairImpact {
    State first, second;
    Impulse impulse;
};
PairImpact after_pair_impact(State const& first, Ball const& one, State const& second, Ball const& other,
                             Vec2 const& normal, double restitution);

}  // namespace physics
