// The path of the player's ball, softened: its mean over the last second or two, whose velocity is continuous where the
// ball's is not.
#pragma once

#include "level/level.h"
#include "physics/world/world.h"

namespace view {

using geometry::Vec2;

// Sideways and up: over which time, s, the place and the velocity are averaged. The velocity turns round at a bounce,
// so it is the one that must be slow. Up and down there is less room to lag behind in.
struct Spans {
    double place, velocity;
    double mean_age() const { return 0.4 * place; }  // of the kernel
};
inline constexpr Spans spans[] = {{1.0, 1.6}, {0.7, 1.2}};
inline constexpr double longest_span = 1.6;       // s
inline constexpr double path_spacing = 1.0 / 60;  // s, the path is taken as straight between whole multiples of it

// m, where the ball is, or where it left the level for good.
Vec2 followed(level::Level const& level, physics::History const& history, double time);

struct PathMean {
    Vec2 position = Vec2::Zero();  // m
    Vec2 velocity = Vec2::Zero();  // m/s
};
PathMean mean_of_path(level::Level const& level, physics::History const& history, double time);

// The share of the kernel's weight that lies on ages below `age`, of a mean over `over` seconds.
double weight_below(double age, double over);

}  // namespace view
