// From a score to samples: a pure function of the sample's number.
#pragma once

#include <vector>

#include "sound/score.h"

namespace sound {

// Samples [first, first + count) of both sides in turn, left first, at `rate`; none is beyond 1. Any stretch by itself
// holds the same numbers as the whole. `first` may be negative.
std::vector<float> samples(Score const& score, long long first, long long count);

// The same into memory that is there: 2 * count numbers. Allocates nothing.
void write_samples(Score const& score, long long first, long long count, float* target);

// Straight up to 0.6, and from there on bent, with a continuous slope, so that it never comes to 1.
double limited(double sample);

}  // namespace sound
