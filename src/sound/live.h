// A score that is heard while it is written: the game adds what has just happened, a device takes samples.
#pragma once

#include <mutex>

#include "game/session.h"
#include "sound/score.h"

namespace sound {

enum class Gate { shut, open };

// What the two threads share. `fill` is for the device's thread, all else for the game's. Where something ends or
// begins the loudness goes there in a few milliseconds, so that nothing clicks.
class Live {
public:
    // Another game, or another moment of one: what sounds is dropped, the tune goes on if it is the world's own.
    void begin(World world);
    // What has happened in (from, until] of the session, told `elapsed` seconds on the wall after what was told before.
    // It is heard within `longest_lead`, at its own place within that time.
    void hear(game::Session const& session, double from, double until, double elapsed);
    // While it is shut the time of the score stands.
    void gate(Gate gate);
    // Of what is heard, in [0, 1].
    void set_volume(double volume);

    // The next samples, both sides in turn: 2 * count numbers.
    void fill(float* target, int count);

    static constexpr double longest_lead = 0.025;  // s, from when something is told until it is heard
    static constexpr double ramp = 0.01;           // s, from silence to full loudness

private:
    std::mutex mutex_;
    Score score_;
    std::optional<Score> next_;  // takes the place of the score once that has faded
    long long playhead_ = 0;     // the next sample that is taken
    long long known_ = 0;        // up to which it is known what happens
    Gate gate_ = Gate::shut;
    double opening_ = 0;  // in [0, 1], of the gate now
    double volume_ = 1, volume_now_ = 1;
};

}  // namespace sound
