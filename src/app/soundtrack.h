// The sound of a session that is simulated from one time to another, stretch by stretch.
#pragma once

#include <vector>

#include "game/session.h"
#include "sound/hear.h"

namespace app {

class Soundtrack {
public:
    // Advances a session that is at its beginning to `from` (s) and hears what still sounds there. Throws what
    // game::advance does, and Interrupted.
    Soundtrack(game::Session& session, double from);

    // Advances the session, keeping what the camera remembers, and returns the samples from where it was before to
    // `until`, both sides in turn. The same times give the same samples, whatever the stretches.
    std::vector<float> on_to(game::Session& session, double until);

private:
    void hear(game::Session& session, double until);

    sound::Score score_;
    double heard_;         // s, up to which the score is known
    long long delivered_;  // samples since the session's beginning
};

}  // namespace app
