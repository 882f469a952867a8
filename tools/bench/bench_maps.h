// Maps: where the drag spring stays stable, which walls hold, and what piles cost; each written as a tab-separated
// table.
#pragma once

#include <ostream>

#include "bench_measure.h"

namespace bench {

// frequency x damping: the error of a unit step over 1000 frames, and whether the ball has run away.
void map_drag(std::vector<Contestant> const& contestants, int columns, int rows, std::ostream& to);

// speed x thickness of a wall: how many of the balls thrown at it get into or through it.
void map_walls(std::vector<Contestant> const& contestants, int columns, int rows, std::ostream& to);

// Piles of so many discs, settled for `settling` seconds and kept awake: cost of a frame and deepest overlap.
void chart_piles(std::vector<int> const& counts, double settling, std::ostream& to);

}  // namespace bench
