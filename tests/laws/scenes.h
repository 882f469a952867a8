// Small scenes with known answers, and short ways to run them.
#pragma once

#include <limits>

#include "geometry/elementary.h"
#include "physics/method.h"

namespace laws {

using geometry::pi;
using geometry::Vec2;

inline constexpr double full_grip = std::numeric_limits<double>::infinity();
inline constexpr double g = 9.81;  // m/s^2, of every scene unless it says otherwise

// The sanitizers slow tests down by more than ten: where cases are many they run fewer.
#ifdef SMB2D_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

inline physics::Material material(double friction, double restitution = 0, double rolling_resistance = 0) {
    return {friction, restitution, rolling_resistance};
}
inline physics::Piece line(Vec2 const& from, Vec2 const& to, physics::Material const& of) {
    return {geometry::Segment{from, to}, of, 0};
}
inline physics::Piece arc(Vec2 const& centre, double radius, double from, double sweep, physics::Material const& of) {
    return {geometry::Arc{centre, radius, from, sweep}, of, 0};
}

// A disc of radius 0.5 m and 1 kg.
physics::Ball disc_at(Vec2 const& position, Vec2 const& velocity = Vec2::Zero(), double spin = 0);

physics::Scene scene_of(std::vector<physics::Piece> pieces, std::vector<physics::Ball> balls);
physics::Scene floor_with(physics::Ball const& ball, physics::Material const& of);

// A slope that falls to the right by `angle`, through the origin; the unit vector down it and its normal.
struct Slope {
    physics::Scene scene;
    Vec2 down = Vec2::Zero();
    Vec2 normal = Vec2::Zero();
};
Slope slope_with(double angle, physics::Ball ball, physics::Material const& of);

// A course with a slope, an arc, a flat stretch and a wall about `origin`; a disc slides down it, rolls, flies, lands.
physics::Scene course_at(Vec2 const& origin, double restitution);

// A world under way.
struct Run {
    physics::Method method;
    physics::Scene scene;
    physics::History history;
    physics::World world;

    Run(physics::Method const& method, physics::Scene const& scene);
    void to(double time);
    void pull(int ball, Vec2 const& target);
    void release();
    physics::State state(int ball = 0) const { return physics::at(world.legs[ball], world.time); }
    physics::Leg const& leg(int ball = 0) const { return world.legs[ball]; }
};
physics::State state_after(physics::Method const& method, physics::Scene const& scene, double time);

// How deep the deepest overlap of two balls, or of a ball with the floor y = 0, is, m; and the fastest ball, m/s.
double deepest_overlap(Run const& run);
double fastest(Run const& run);

// How high the centre of ball 0 comes, m, in the second after ball 1, which has pressed it for 2 s, is pulled off it.
double highest_when_unloaded(Run& run);

// The sum of mass times velocity, kg m/s.
Vec2 momentum_of(Run const& run);

bool same_bits(physics::State const& a, physics::State const& b);

// Kinetic energy of centre and spin, and height; of all balls.
double energy_of(Run const& run);

int count_of(physics::History const& history, physics::EventKind kind);

}  // namespace laws
