// Simulating a long time when nobody looks at what lies between: in bounded memory, and stopping on Ctrl-C.
#pragma once

#include "game/session.h"

namespace app {

// On to `until`, forgetting what lies more than `memory` seconds back. Throws Interrupted.
void advance_in_chunks(game::Session& session, double until, double memory = 0);

}  // namespace app
