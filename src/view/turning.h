// The picture turned as gravity is: tilting is seen as tilting, though the world's axes stay.
#pragma once

#include "game/session.h"
#include "view/camera.h"

namespace view {

enum class Turning { with_gravity, never };

// rad, counter-clockwise: a weighted mean of gravity's angle over the last turn_span, so that its rate is continuous.
// Exactly the angle where it has stayed the same for so long.
inline constexpr double turn_span = 0.5;  // s
static_assert(turn_span < camera_memory);
double turn_at(game::Session const& session, double time);

// What a game is seen through at a time that is not forgotten.
Camera camera_of(game::Session const& session, double time, Vec2 const& size, Turning turning = Turning::with_gravity,
                 Lens const& lens = {});

}  // namespace view
