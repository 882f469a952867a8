// A ball: what never changes about it, and its state at one moment.
#pragma once

#include "geometry/vector.h"

namespace physics {

using geometry::Vec2;

struct State {
    Vec2 position = Vec2::Zero();  // m, the centre
    Vec2 velocity = Vec2::Zero();  // m/s
    double angle = 0;              // rad, total, counter-clockwise, never wrapped
    double spin = 0;               // rad/s, counter-clockwise
};

struct Ball {
    double radius = 0.5;       // m
    double mass = 1;           // kg
    double inertia = 0.5;      // k = I/(m r^2): 1 a hoop, 1/2 a disc, 0 all mass at the hub
    double friction = 0.3;     // ball against ball only
    double restitution = 0.5;  // ball against ball only
    State start;
};

}  // namespace physics
