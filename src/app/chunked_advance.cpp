#include "app/chunked_advance.h"

#include <algorithm>

#include "app/interrupt.h"

namespace app {

namespace {

constexpr double longest_stretch = 0.25;  // s, short enough for Ctrl-C to be heard at once

}  // namespace

void advance_in_chunks(game::Session& session, double until, double memory) {
    while (session.world.time + longest_stretch < until) {
        stop_if_interrupted();
        game::advance(session, session.world.time + longest_stretch);
        game::forget_before(session, std::max(0.0, session.world.time - memory));
    }
    stop_if_interrupted();
    game::advance(session, until);
}

}  // namespace app
