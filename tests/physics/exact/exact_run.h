// A stage for tests of the exact method: a scene of lines, arcs and discs whose world is advanced and asked.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include <doctest/doctest.h>

#include "physics/method.h"

namespace context {

using namespace physics;

inline constexpr double full_grip = std::numeric_limits<double>::infinity();

inline Piece line(Vec2 const& from, Vec2 const& to, Material const& material = {}) {
    return {geometry::Segment{from, to}, material, 0};
}

inline Ball disc(double radius, Vec2 const& position, Vec2 const& velocity = Vec2::Zero(), double spin = 0) {
    Ball ball;
    ball.radius = radius;
    ball.start = {position, velocity, 0, spin};
    return ball;
}

inline double energy_of(Ball const& ball, State const& s, double gravity) {
    return ball.mass * (0.5 * geometry::dot(s.velocity, s.velocity) +
                        0.5 * ball.inertia * ball.radius * ball.radius * s.spin * s.spin + gravity * s.position.y());
}

struct StepContext {
    Scene scene;
    History history;
    World world;

    StepContext(std::vector<Piece> pieces, std::vector<Ball> balls, double gravity = 9.81) {
        scene.terrain = terrain_of(std::move(pieces));
        scene.balls = std::move(balls);
        scene.gravity = gravity;
        world = world_at_start(Exact{}, scene, history);
    }
    void to(double time) { REQUIRE_FALSE(advance(Exact{}, scene, world, time, history)); }
    void pull(std::optional<Pull> const& pulled) {
        Forces forces = world.forces;
        forces.pull = pulled;
        REQUIRE_FALSE(apply(Exact{}, scene, world, forces, history));
    }
    State now(int ball = 0) const { return at(world.legs[static_cast<std::size_t>(ball)], world.time); }
    int count(EventKind kind) const {
        return static_cast<int>(std::count_if(history.events.begin(), history.events.end(),
                                              [&](Event const& e) { return e.kind == kind; }));
    }
    double energy() const {
        double sum = 0;
        for (std::size_t i = 0; i < scene.balls.size(); ++i)
            sum += energy_of(scene.balls[i], now(static_cast<int>(i)), scene.gravity);
        return sum;
    }
    // How far the nearest ball is from touching terrain, m; negative when one is inside.
    double clearance() const {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < scene.balls.size(); ++i)
            for (Piece const& piece : scene.terrain.pieces)
                least = std::min(least, nearest_point(piece.curve, now(static_cast<int>(i)).position).distance -
                                            scene.balls[i].radius);
        return least;
    }
};

}  // namespace context
