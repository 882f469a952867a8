#include "game/pace.h"

#include <algorithm>
#include <cmath>

namespace game {

Pace after(Pace pace, double elapsed) {
    if (pace.paused || !(elapsed > 0)) return pace;
    double const most = static_cast<double>(catch_up_frames * ticks_per_frame);
    double const owed = std::min(elapsed * ticks_per_second * pace.speed + pace.rest, most);
    double const whole = std::floor(owed);
    pace.ticks += static_cast<long long>(whole);
    pace.rest = owed - whole;
    return pace;
}

Pace after_single_step(Pace pace) {
    pace.ticks = (pace.ticks / ticks_per_frame + 1) * ticks_per_frame;
    pace.rest = 0;
    return pace;
}

}  // namespace game
