#include "game/pace.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

using game::Pace;
using game::simulated_time;

TEST_CASE("T18: an hour of frames of 1/60 s is an hour, without drift") {
    Pace pace;
    for (int frame = 0; frame < 60 * 3600; ++frame) pace = game::after(pace, 1.0 / 60);
    // A tick at most is owed; sums of 1/60 in single precision would be seconds off.
    CHECK(std::abs(simulated_time(pace) - 3600) <= 1 / game::ticks_per_second);
}

TEST_CASE("T17: after a long frame at most eight frames are caught up with") {
    CHECK(simulated_time(game::after(Pace{}, 2.0)) == 8.0 / 60);
    CHECK(simulated_time(game::after(Pace{}, 1e300)) == 8.0 / 60);
    CHECK(simulated_time(game::after(Pace{}, std::numeric_limits<double>::infinity())) == 8.0 / 60);
}

TEST_CASE("slow motion slows time down") {
    Pace pace;
    pace.speed = 0.25;
    for (int frame = 0; frame < 240; ++frame) pace = game::after(pace, 1.0 / 60);
    CHECK(std::abs(simulated_time(pace) - 1) <= 1 / game::ticks_per_second);
}

TEST_CASE("while paused only single steps pass, to whole frames") {
    Pace pace = game::after(Pace{}, 0.04);
    pace.paused = true;
    CHECK(simulated_time(game::after(pace, 0.1)) == simulated_time(pace));
    pace = game::after_single_step(pace);
    CHECK(simulated_time(pace) == 3.0 / 60);  // 0.04 s lies between frames 2 and 3
    CHECK(simulated_time(game::after_single_step(pace)) == 4.0 / 60);
}

TEST_CASE("a clock that goes backwards, or is broken, stops time") {
    CHECK(simulated_time(game::after(Pace{}, -1)) == 0);
    CHECK(simulated_time(game::after(Pace{}, std::nan(""))) == 0);
}
