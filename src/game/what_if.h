// What is going to happen if the player does one thing now and then nothing. The game is not touched.
#pragma once

#include <optional>

#include "game/session.h"

namespace game {

// The legs and events from world.time to `horizon` seconds later, inputs that a run still holds left out.
physics::History what_if(Session const& session, std::optional<Action> const& action, double horizon);

// The same while the player goes on holding the ball with the pointer where it is now in the world.
physics::History what_if_held(Session const& session, Vec2 const& pointer, double horizon);

}  // namespace game
