// The same ground drawn otherwise: backwards, in pieces, shuffled, split, twice.
#pragma once

#include <vector>

#include "hunt/dice.h"
#include "hunt/sketch.h"

namespace hunt {

Stroke backwards(Stroke const& stroke);

// Two or three strokes that cover the same line or arc, in order; other strokes stay whole.
std::vector<Stroke> split(Dice& dice, Stroke const& stroke);

}  // namespace hunt
