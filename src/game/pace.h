// Pace: from seconds on the wall to simulated time, with slow motion, pause, single steps and a cap on catching up.
#pragma once

namespace game {

// Time is counted in ticks, never summed. A tick divides 1/60 s, 1/240 s and 1/1000 s.
inline constexpr double ticks_per_second = 960000;
inline constexpr long long ticks_per_frame = 16000;  // 1/60 s, what a single step shows

// After a long frame the game falls behind the wall rather than work ever longer (T17 in tests/laws).
inline constexpr int catch_up_frames = 8;

struct Pace {
    long long ticks = 0;  // simulated
    double rest = 0;      // ticks owed, less than one
    double speed = 1;     // simulated seconds in a second; 0.25 is slow motion
    bool paused = false;
};

inline double simulated_time(Pace const& pace) { return static_cast<double>(pace.ticks) / ticks_per_second; }  // s

// After `elapsed` seconds on the wall. What is negative or not a number counts as nothing.
Pace after(Pace pace, double elapsed);

// On to the next whole frame, paused or not.
Pace after_single_step(Pace pace);

}  // namespace game
