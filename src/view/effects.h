// What balls raise and leave behind: trails and dust behind them, sparks before them.
#pragma once

#include <vector>

#include "level/level.h"
#include "view/camera.h"
#include "view/moment.h"
#include "view/picture.h"

namespace view {

std::vector<Shape> trail_shapes(level::Level const& level, Moment const& moment, Camera const& camera);
std::vector<Shape> dust_shapes(Moment const& moment, Camera const& camera);
std::vector<Shape> spark_shapes(Moment const& moment, Camera const& camera);

// How the monkey in a ball bears itself: upright and running while that rolls, thrown about while it flies or slips. It
// looks at `pointer`, pixels, else ahead.
Monkey monkey_of(Moment const& moment, int ball, Shell const& shell, Camera const& camera,
                 std::optional<Vec2> const& pointer);

}  // namespace view
