// Which ends of curves are one point.
#pragma once

#include <vector>

#include "physics/terrain/terrain.h"

namespace physics {

// Ends within `vertex_reach` of each other are one place, and so are chains of such ends: the first of the chain by x,
// then y.
struct Places {
    std::vector<Vec2> points;  // m, in lexicographic order
    std::vector<int> of_end;   // which point, by end
};
Places places_of(std::vector<Vec2> const& ends);

}  // namespace physics
