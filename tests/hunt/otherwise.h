// The same ground drawn otherwise: backwards, in pieces, shuffled, split, twice. The ball moves as before.
#pragma once

#include <optional>
#include <vector>

#include "hunt/dice.h"
#include "hunt/judge.h"
#include "hunt/sketch.h"

namespace hunt {

Stroke backwards(Stroke const& stroke);

// Two strokes that cover the same line or arc, in order; other strokes stay whole.
std::vector<Stroke> split(Dice& dice, Stroke const& stroke);

struct Redrawing {
    char const* name;
    Sketch sketch;
};
// Only those that say the same to rounding: curves are not turned round, as they are approximated from their starts,
// and arcs of nearly half a turn keep their ends, from which their centres are found.
std::vector<Redrawing> redrawings_of(Sketch const& sketch);

// The largest way between where the ball is and where it is on a redrawing, until the sixth event (joints do not
// count), where that is more than 1e-9 m (of 10 m) and ball and ground are not such that starts a picometre apart
// part as far.
std::optional<Finding> moves_otherwise(Sketch const& sketch);

}  // namespace hunt
