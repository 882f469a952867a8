// TrajectoryPreview: where a ball is going to be, as dots that it will pass and rings where it will touch.
#pragma once

#include <vector>

#include "physics/world/world.h"
#include "view/camera.h"
#include "view/picture.h"

namespace view {

enum class Premise { held, let_go };  // what the player is taken to do from now on

struct TrajectoryPreview {
    struct Sight {
        Vec2 place = Vec2::Zero();  // m, of the ball's centre
        double ahead = 0;           // s from now
    };
    Premise premise = Premise::held;
    double radius = 0;           // m, of the ball
    double horizon = 0;          // s, how far ahead it looks
    std::vector<Sight> dots;     // at whole multiples of dot_spacing, so that they stand still while the ball moves
    std::vector<Sight> touches;  // where it lands, bounces or hits another ball
};

inline constexpr double dot_spacing = 1.0 / 40;  // s

// Of what is known to come, from `time` to `horizon` seconds later.
TrajectoryPreview trajectory_preview(physics::History const& coming, physics::Scene const& scene, int ball, double time,
                       double horizon);

// Behind the balls.
std::vector<Shape> trajectory_shapes(TrajectoryPreview const& preview, Camera const& camera);

}  // namespace view
