// Sweeps: what terrain a ball meets first, in flight or along a track.
#pragma once

#include <array>

#include "physics/leg.h"
#include "physics/terrain.h"

namespace physics {

// Nearer than this a ball touches: what it approaches it meets at once, what it leaves it has left. m, formats.md 3.
inline constexpr double touch_reach = 1e-9;

// Whether a ball in direction `out` from the arc's centre is over the arc, its ends reached beyond by touch_reach.
bool spans_loosely(geometry::Arc const& arc, Vec2 const& out);

// c(t) = position + velocity t + acceleration t^2 / 2.
struct Parabola {
    Vec2 position = Vec2::Zero();
    Vec2 velocity = Vec2::Zero();
    Vec2 acceleration = Vec2::Zero();
};

struct Obstacle {
    double time = never;  // s since the sweep began; along a track, m of way
    Contact contact;
};

// Features that a sweep does not look at: those the ball is on, and their smooth neighbours.
struct Skipped {
    std::array<int, 8> features{-1, -1, -1, -1, -1, -1, -1, -1};
    bool has(int feature) const {
        for (int const f : features)
            if (f == feature) return true;
        return false;
    }
};

// The first terrain that a ball meets within `until` (may be infinite). From `left` it has just parted, with no gap.
Obstacle first_obstacle(Terrain const& terrain, Parabola const& path, double radius, double until, Contact left,
                        Skipped const& skipped);

// The same for flight on the drag spring, between `from` and `until` seconds (finite) after the leg began. Without a
// contact the time is how far has been searched.
Obstacle first_obstacle(Terrain const& terrain, Leg const& spring_flight, double radius, double from, double until,
                        Contact left);

// The first terrain in the way of a ball that follows a circular track from q, forwards (+1) or backwards (-1), within
// `until` metres.
Obstacle first_obstacle(Terrain const& terrain, Track const& circle, double q, int direction, double radius,
                        double until, Skipped const& skipped);

// What a ball touches where it is, with the unit normals; features that share a normal at a joint count once.
struct Support {
    Contact contact;
    Vec2 normal = Vec2::UnitY();
};
std::vector<Support> supports_at(Terrain const& terrain, Vec2 const& centre, double radius);

}  // namespace physics
