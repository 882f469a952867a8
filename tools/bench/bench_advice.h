// Advice measured: writes the table that physics/advice.h foretells from, and judges it on scenes it was not fitted on.
#pragma once

#include <ostream>

#include "bench_measure.h"
#include "physics/advice.h"

namespace bench {

inline constexpr double settling = 6;              // s, of the piles that are learnt from and judged
inline constexpr double pile_rates[] = {60, 240};  // steps/s, at which

// Fitted to the scenes of the folder `lab`, to those with arcs in pieces, to gases and to piles.
physics::Experience experience_from(std::string const& lab, Effort const& effort);

// As src/physics/advice_table.inc.
void write_experience(physics::Experience const& experience, std::ostream& to);

// One row a scene and tolerance: what was advised, whether it kept the tolerance, what it cost against the cheapest
// that does; ends with the shares asked for. Scenes are drawn at random, so many of each kind, or are levels that ship.
void judge_advice(physics::Experience const& experience, std::string const& levels, int scenes, std::ostream& to);

}  // namespace bench
