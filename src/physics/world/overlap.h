// How far balls reach into each other and into the terrain.
#pragma once

#include <vector>

#include "physics/world/scene.h"

namespace physics {

// The deepest overlap of any ball with another or with terrain when their centres are at these places, by ball; 0 where
// nothing overlaps. m.
double deepest_overlap(Scene const& scene, std::vector<Vec2> const& centres);

}  // namespace physics
