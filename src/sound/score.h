// What is to be heard, as plain data: struck and sung notes, what rolls and slips, and a tune.
#pragma once

#include <deque>
#include <optional>
#include <vector>

namespace sound {

inline constexpr int rate = 48000;       // samples a second
inline constexpr int motion_step = 128;  // samples from one row of a motion to the next
inline constexpr int most_motions = 4;   // balls that are heard to roll: the player's and the first others

enum class Timbre {
    wood,     // a ball on ground
    glass,    // on ground with little friction
    rubber,   // on ground that throws back
    marble,   // ball against ball
    twang,    // the spring
    pling,    // a banana
    bell,     // the goal
    whistle,  // a fall
    gong,     // the end of the time
    kalimba,
    oud,
    celesta,
    vibraphone,
    bass,
    pad,
    drum
};

struct Note {
    long long start = 0;  // the sample at which it begins
    Timbre timbre = Timbre::wood;
    double pitch = 440;     // Hz
    double loudness = 0;    // about its greatest sample, of 1
    double brightness = 1;  // in [0, 1]: of the partials above the first
    double pan = 0;         // from -1, left, to 1, right
};

// How a ball rolls, slips and pulls at its spring at one moment.
struct Motion {
    double roll = 0;      // loudness, about the greatest sample, of 1
    double way = 0;       // grains of the ground rolled over
    double hardness = 0;  // in [0, 1]: from soft ground to ice
    double slip = 0;      // loudness
    double scrape = 0;    // in [0, 1]: how high the slip is heard
    double tension = 0;   // in [0, 1]: of the spring
    double pan = 0;
};

// Rows at samples (first + i) * motion_step. Between rows all numbers go in straight lines.
struct Motions {
    long long first = 0;
    std::vector<std::deque<Motion>> rows;  // by ball that is heard, all of the same length
};

enum class World { meadow, desert, ice, night };
struct Playing {
    World world = World::meadow;
    long long since = 0;  // the sample at which the tune began; it never ends
};

struct Score {
    std::vector<Note> notes;  // in order of their starts
    Motions motions;
    std::optional<Playing> tune;
};

// Drops what can no longer be heard from the sample on.
void forget_before(Score& score, long long sample);

}  // namespace sound
