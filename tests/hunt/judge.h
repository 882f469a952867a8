// The judge: plays a sketch and says what is wrong with what happened, by its own sight of ground and energy.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hunt/sketch.h"

namespace hunt {

// In order of weight: the first of several is what a case is filed under.
enum class Wrong {
    refused,     // the reader says no, or the method cannot go on
    no_end,      // s of processor time after which it was given up, or a crash
    not_finite,  // m
    handover,    // a lone ball was handed over
    depth,       // m, inside the ground as read
    drawn,       // m, inside the ground as drawn
    jump,        // m, from one leg to the next
    energy,      // share gained
    hover,       // m above the ground that it is said to touch
    held,        // m/s^2: at rest where nothing holds it
    rows,        // another end when asked at other times
    crowd,       // events in a tenth of a second
    otherwise,   // m, from where it is when the same ground is drawn otherwise
    slow,        // s of processor time for the whole
    stall        // s of processor time for a sixtieth
};
char const* name_of(Wrong wrong);

struct Finding {
    Wrong wrong = Wrong::depth;
    double measured = 0;
    double time = 0;  // s
    std::string words;
};

struct Verdict {
    std::vector<Finding> findings;  // one a kind, in order of weight
    long long events = 0;
    double busiest = 0;    // events, in a tenth of a second
    double seconds = 0;    // s of processor time, of the run asked for in sixtieths
    double worst_row = 0;  // s of processor time, of a sixtieth
    double end = 0;        // s, when the ball fell out or the run ended
};

// What is not asserted in tests, where machines are shared and sanitizers slow.
enum class Clock { ignored, judged };

Verdict judged(Sketch const& sketch, physics::Method const& method, Clock clock);

}  // namespace hunt
