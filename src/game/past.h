// The past that is kept for looking back: some minutes, and no more memory than is good.
#pragma once

#include <cstddef>

#include "game/session.h"

namespace game {

struct PastLimits {
    double longest = 300;              // s
    double shortest = 5;               // s, kept whatever it takes
    std::size_t bytes = 64 * 1048576;  // of legs and events
};

// An upper bound of what a history takes under a method, but for the first leg of every ball.
std::size_t bytes_of(physics::History const& history, physics::Method const& method);

// Drops what of the session's past is beyond the limits, seen from `now`.
void keep_past(Session& session, double now, PastLimits const& limits = {});

}  // namespace game
