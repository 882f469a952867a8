// Timbres: every note is a sum of decaying sines, so that any of its samples is known by itself.
#pragma once

#include <span>

#include "sound/score.h"

namespace sound {

struct Partial {
    double ratio = 1;  // of its frequency to the note's pitch
    double gain = 1;
    double decay = 0;  // 1/s, of the amplitude
};

struct Voice {
    std::span<Partial const> partials;
    double attack = 0;  // s, of a raised cosine
    double length = 0;  // s, of the whole note; a raised cosine ends it
    double glide = 0;   // 1/s, at which the pitch falls
};
Voice const& voice_of(Timbre timbre);

// The longest note that a game strikes, tunes left out.
inline constexpr double longest_note = 3;  // s

// How many samples the note is heard for.
long long length_of(Note const& note);

// Adds the note's samples [first, first + count) to left and right. The numbers do not depend on where a stretch of
// samples that is asked for begins as long as that is a multiple of `block` or the note's start.
inline constexpr int block = 64;  // samples
void add_note(Note const& note, long long first, int count, double* left, double* right);

}  // namespace sound
