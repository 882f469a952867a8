// What of a game is heard: its events become notes, its legs the sound of rolling, its pulls that of the spring.
#pragma once

#include "game/session.h"
#include "sound/score.h"

namespace sound {

// Which time of the game is heard at which sample: sample + (t - time) * samples_a_second.
struct Clock {
    double time = 0;                 // s
    long long sample = 0;            // heard then
    double samples_a_second = rate;  // more in slow motion
};
long long sample_at(Clock const& clock, double time);  // the nearest

// Adds to the score what happens in (from, until] of the session, which must have been advanced to `until` and know its
// history from `from` on. Stretches are added in order of time: whatever they are, the same comes of the whole.
void hear(Score& score, game::Session const& session, double from, double until, Clock const& clock);

// The world whose tune suits the level, by the colours behind it: dark above is night, hills more red than green are
// desert, more blue than green ice, all else is meadow.
World world_of(level::Level const& level);

// How loud and how bright a blow is that changes the velocity by so much, m/s; below `faintest` there is none.
inline constexpr double faintest_blow = 0.12;  // m/s
double loudness_of_blow(double speed);

}  // namespace sound
