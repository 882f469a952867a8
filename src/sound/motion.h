// What rolls, slips and is pulled, as samples.
#pragma once

#include "sound/score.h"

namespace sound {

// Adds the samples [first, first + count) to left and right, of which each hangs on the two rows before it. Before the
// first row and after the last but for a short fading there is silence.
void add_motions(Motions const& motions, long long first, int count, double* left, double* right);

}  // namespace sound
