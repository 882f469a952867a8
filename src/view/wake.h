// What a ball's last moments leave to be seen: how its monkey bears them, dust, sparks, a trail. Decoration alone: a
// function of the history and the time.
#pragma once

#include <vector>

#include "level/level.h"
#include "physics/world/world.h"
#include "view/camera.h"

namespace view {

inline constexpr double wake_memory = 0.7;  // s: nothing of before is seen
static_assert(wake_memory < camera_memory);

struct Fleck {
    Vec2 place = Vec2::Zero();  // m
    Vec2 way = Vec2::Zero();    // m/s
    double age = 0;             // 0 new to 1 gone
    double size = 0;            // m
};

struct Wake {
    double loose = 0;           // 0 to 1: how much of the last half second the ball spent flying or slipping
    double spin = 0;            // rad/s, a mean: continuous where the ball's is not
    Vec2 push = Vec2::Zero();   // m/s^2, the mean acceleration: continuous
    double haste = 0;           // 0 to 1: how far it is fast for its size
    std::vector<Vec2> trail;    // m, where it was, the newest last; empty where it is not fast
    std::vector<Fleck> dust;    // while it slips
    std::vector<Fleck> sparks;  // after a hard bounce
};
Wake wake_of(level::Level const& level, physics::History const& history, int ball, double time);

}  // namespace view
