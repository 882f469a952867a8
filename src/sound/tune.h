// The tunes: one for each world, of a scale, a tempo and voices of its own. Notes as a function of time.
#pragma once

#include <vector>

#include "sound/score.h"

namespace sound {

// Samples from one beginning of the tune to the next.
long long loop_of(World world);

// The notes that begin at samples [first, last).
std::vector<Note> tune_notes(Playing const& tune, long long first, long long last);

// Adds the samples [first, first + count) of all notes that sound there.
void add_tune(Playing const& tune, long long first, int count, double* left, double* right);

// The pitch of a step of the world's scale, 0 being its root near middle C; steps beyond a scale go on in the next
// octave. Hz
double pitch_in(World world, int step);

}  // namespace sound
