// Small scenes with known answers, and short ways to run them: for the tests of every floor.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "geometry/elementary.h"
#include "physics/method.h"
#include "support/sanitized.h"

namespace scenes {

using geometry::pi;
using geometry::Vec2;

inline constexpr double full_grip = std::numeric_limits<double>::infinity();
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double g = 9.81;  // m/s^2, of every scene unless it says otherwise

inline physics::Material material(double friction, double restitution = 0, double rolling_resistance = 0) {
    return {friction, restitution, rolling_resistance};
}
inline physics::Piece line(Vec2 const& from, Vec2 const& to, physics::Material const& of = {}) {
    return {geometry::Segment{from, to}, of, 0};
}
inline physics::Piece arc(Vec2 const& centre, double radius, double from, double sweep,
                          physics::Material const& of = {}) {
    return {geometry::Arc{centre, radius, from, sweep}, of, 0};
}
// Lines from one corner to the next.
inline std::vector<physics::Piece> chain(std::vector<Vec2> const& corners, physics::Material const& of = {}) {
    std::vector<physics::Piece> pieces;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) pieces.push_back(line(corners[i], corners[i + 1], of));
    return pieces;
}
// The same, closed.
inline std::vector<physics::Piece> ring(std::vector<Vec2> corners, physics::Material const& of = {}) {
    corners.push_back(corners.front());
    return chain(corners, of);
}

// Of 1 kg.
inline physics::Ball disc(double radius, Vec2 const& position, Vec2 const& velocity = Vec2::Zero(), double spin = 0) {
    physics::Ball ball;
    ball.radius = radius;
    ball.start = {position, velocity, 0, spin};
    return ball;
}
inline physics::Ball disc_at(Vec2 const& position, Vec2 const& velocity = Vec2::Zero(), double spin = 0) {
    return disc(0.5, position, velocity, spin);
}
// A disc of radius 0.5 m that rolls to the right on what is level below it.
inline physics::Ball rolling(Vec2 const& position, double speed) { return disc_at(position, {speed, 0}, -speed / 0.5); }

inline physics::Scene scene_of(std::vector<physics::Piece> pieces, std::vector<physics::Ball> balls,
                               double gravity = g) {
    physics::Scene scene;
    scene.terrain = physics::terrain_of(std::move(pieces));
    scene.balls = std::move(balls);
    scene.gravity = gravity;
    return scene;
}
inline physics::Scene floor_with(physics::Ball const& ball, physics::Material const& of = {}, double gravity = g) {
    return scene_of({line({-1000, 0}, {1000, 0}, of)}, {ball}, gravity);
}

// A slope that falls to the right by `angle`, through the origin; the unit vector down it and its normal.
struct Slope {
    physics::Scene scene;
    Vec2 down = Vec2::Zero();
    Vec2 normal = Vec2::Zero();
};
inline Slope slope_with(double angle, physics::Ball ball, physics::Material const& of) {
    Slope slope;
    slope.down = Vec2(std::cos(angle), -std::sin(angle));
    slope.normal = geometry::turned_left(slope.down);
    ball.start.position = ball.radius * slope.normal;
    slope.scene = scene_of({line(-200 * slope.down, 200 * slope.down, of)}, {ball});
    return slope;
}

// A course with a slope, an arc, a flat stretch and a wall, turned about its origin, scaled and moved there: a disc
// slides down it, rolls, flies, lands.
inline std::vector<physics::Piece> course(Vec2 const& origin, double restitution, double turn = 0, double scale = 1) {
    auto const of = material(0.3, restitution, 0.01);
    auto const [sine, cosine] = geometry::sine_cosine(turn);
    auto const put = [&, s = sine, c = cosine](double x, double y) -> Vec2 {
        return origin + scale * geometry::turned(Vec2(x, y), c, s);
    };
    std::vector<physics::Piece> pieces = chain({put(-4, 8), put(-4, 4), put(0, 1), put(3, 1)}, of);
    pieces.push_back(arc(put(3, 3), 2 * scale, turn - pi / 2, pi / 3, of));
    for (physics::Piece const& piece : chain({put(6, 0), put(12, 0), put(12, 6)}, of)) pieces.push_back(piece);
    return pieces;
}
inline physics::Scene course_at(Vec2 const& origin, double restitution, double height = 4.25) {
    return scene_of(course(origin, restitution), {disc_at(origin + Vec2(-2, height))});
}

// A world under way. What the method refuses fails the test.
struct Run {
    physics::Method method;
    physics::Scene scene;
    physics::History history;
    physics::World world;

    Run(physics::Method const& m, physics::Scene const& s)
        : method(m), scene(s), world(physics::world_at_start(method, scene, history)) {}

    void to(double time) {
        if (physics::advance(method, scene, world, time, history)) FAIL("the method refuses");
    }
    std::optional<physics::Fault> apply(physics::Forces const& forces) {
        return physics::apply(method, scene, world, forces, history);
    }
    void pull(int ball, Vec2 const& target) { REQUIRE_FALSE(apply({world.forces.tilt, physics::Pull{ball, target}})); }
    void release() { REQUIRE_FALSE(apply({world.forces.tilt, {}})); }
    void tilt(double angle) { REQUIRE_FALSE(apply({angle, world.forces.pull})); }

    physics::State state(int ball = 0) const { return physics::at(leg(ball), world.time); }
    physics::Leg const& leg(int ball = 0) const { return world.legs[static_cast<std::size_t>(ball)]; }
    int count(physics::EventKind kind) const {
        return static_cast<int>(std::count_if(history.events.begin(), history.events.end(),
                                              [&](physics::Event const& event) { return event.kind == kind; }));
    }
    // Of the first event of the kind, or never.
    double time_of(physics::EventKind kind) const {
        for (physics::Event const& event : history.events)
            if (event.kind == kind) return event.time;
        return physics::never;
    }
};

// One under the exact method.
inline Run exact_run(std::vector<physics::Piece> pieces, std::vector<physics::Ball> balls, double gravity = g) {
    return {physics::Exact{}, scene_of(std::move(pieces), std::move(balls), gravity)};
}

inline physics::State state_after(physics::Method const& method, physics::Scene const& scene, double time) {
    Run run(method, scene);
    run.to(time);
    return run.state();
}

// The deepest overlap of two balls, or of a ball with the floor y = 0, m; and the fastest ball, m/s.
inline double deepest_overlap(Run const& run) {
    double deepest = 0;
    for (std::size_t i = 0; i < run.scene.balls.size(); ++i) {
        double const r = run.scene.balls[i].radius;
        Vec2 const p = run.state(static_cast<int>(i)).position;
        deepest = std::max(deepest, r - p.y());
        for (std::size_t j = 0; j < i; ++j) {
            double const between = geometry::length(p - run.state(static_cast<int>(j)).position);
            deepest = std::max(deepest, r + run.scene.balls[j].radius - between);
        }
    }
    return deepest;
}
inline double fastest(Run const& run) {
    double most = 0;
    for (int i = 0; i < static_cast<int>(run.scene.balls.size()); ++i)
        most = std::max(most, geometry::length(run.state(i).velocity));
    return most;
}

// How far the nearest ball is from touching terrain, m; negative when one is inside.
inline double clearance(Run const& run) {
    double least = physics::never;
    for (std::size_t i = 0; i < run.scene.balls.size(); ++i)
        for (physics::Piece const& piece : run.scene.terrain.pieces) {
            Vec2 const place = run.state(static_cast<int>(i)).position;
            least = std::min(least, nearest_point(piece.curve, place).distance - run.scene.balls[i].radius);
        }
    return least;
}

// The sum of mass times velocity, kg m/s.
inline Vec2 momentum_of(Run const& run) {
    Vec2 sum = Vec2::Zero();
    for (std::size_t i = 0; i < run.scene.balls.size(); ++i)
        sum += run.scene.balls[i].mass * run.state(static_cast<int>(i)).velocity;
    return sum;
}

// Of centre and spin, J.
inline double kinetic_energy(physics::Ball const& ball, physics::State const& state) {
    double const rim = ball.radius * state.spin;
    return 0.5 * ball.mass * (geometry::dot(state.velocity, state.velocity) + ball.inertia * rim * rim);
}
// And height; of all balls.
inline double energy_of(Run const& run) {
    double energy = 0;
    for (std::size_t i = 0; i < run.scene.balls.size(); ++i) {
        physics::Ball const& ball = run.scene.balls[i];
        physics::State const state = run.state(static_cast<int>(i));
        energy += kinetic_energy(ball, state) + ball.mass * run.scene.gravity * state.position.y();
    }
    return energy;
}

inline bool same_bits(physics::State const& a, physics::State const& b) {
    double const p[] = {a.position.x(), a.position.y(), a.velocity.x(), a.velocity.y(), a.angle, a.spin};
    double const q[] = {b.position.x(), b.position.y(), b.velocity.x(), b.velocity.y(), b.angle, b.spin};
    return std::memcmp(p, q, sizeof p) == 0;
}
inline bool is_finite(physics::State const& state) {
    return geometry::is_finite(state.position) && geometry::is_finite(state.velocity) &&
           std::isfinite(state.angle + state.spin);
}

}  // namespace scenes
