// What moves, or waits to be reached: balls and their shadows, bananas, the goal, the spring that drags.
#pragma once

#include <vector>

#include "level/level.h"
#include "view/camera.h"
#include "view/moment.h"
#include "view/picture.h"

namespace view {

// Behind the balls.
std::vector<Shape> goal_shapes(level::Level const& level, Moment const& moment, Camera const& camera);
std::vector<Shape> banana_shapes(level::Level const& level, Moment const& moment, Camera const& camera);
std::vector<Shape> shadow_shapes(level::Level const& level, Moment const& moment, Camera const& camera);

// The player's monkey looks at `pointer`, pixels, where there is one.
std::vector<Shape> ball_shapes(level::Level const& level, Moment const& moment, Camera const& camera,
                               std::optional<Vec2> const& pointer = std::nullopt);

// Before the balls: bananas that have just been picked up.
std::vector<Shape> pick_shapes(level::Level const& level, Moment const& moment, Camera const& camera);

// Before the balls; empty where nothing is dragged.
std::vector<Shape> spring_shapes(level::Level const& level, Moment const& moment, Camera const& camera);

}  // namespace view
