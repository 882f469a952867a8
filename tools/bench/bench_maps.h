// Maps: where the drag spring stays stable, which walls and which columns hold, how energy is kept; each written as a
// tab-separated table. Nothing is timed.
#pragma once

#include <ostream>

#include "bench_measure.h"

namespace bench {

// frequency x damping: the error of a unit step over 1000 frames, and whether the ball has run away.
void map_drag(std::vector<Contestant> const& contestants, int columns, int rows, std::ostream& to);

// speed x thickness of a wall: how many of the balls thrown at it get into or through it.
void map_walls(std::vector<Contestant> const& contestants, int columns, int rows, std::ostream& to);

// height x mass ratio: how deep the balls of a column sink into each other below a heavy one, and whether it stands.
void map_stacks(std::vector<int> const& heights, std::vector<double> const& ratios, double settling, std::ostream& to);

// Over time, where energy should stay as it is: the largest change of each second.
void chart_energy(std::string const& lab, std::vector<Contestant> const& contestants, int seconds, std::ostream& to);

}  // namespace bench
