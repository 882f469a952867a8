// A scene: everything that does not change while time passes.
#pragma once

#include <variant>
#include <vector>

#include "physics/motion/ball.h"
#include "physics/terrain/terrain.h"

namespace physics {

// A region that notices balls; physics does not know what for.
struct DiscRegion {
    Vec2 centre = Vec2::Zero();
    double radius = 0;  // m
};
struct PolygonRegion {
    std::vector<Vec2> corners;  // convex, counter-clockwise
};
struct LineRegion {  // crossed, from either side
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};
using Region = std::variant<DiscRegion, PolygonRegion, LineRegion>;

struct Sensor {
    Region region;
    int ball = -1;           // which ball it notices; -1 = any
    bool rim = false;        // a ball counts from where its rim touches (discs only), else from where its centre enters
    bool outside = false;    // it notices leaving in place of entering (polygons only)
    bool each_ball = false;  // it fires once for every ball, else once in all
};

// The spring by which a ball is dragged (docs/runs-and-traces.md).
struct DragSpring {
    double frequency = 3;  // Hz, undamped
    double damping = 0.7;  // of critical
};

struct Scene {
    Terrain terrain;
    std::vector<Ball> balls;
    std::vector<Sensor> sensors;
    double gravity = 9.81;  // m/s^2, down
    DragSpring drag;
};

}  // namespace physics
