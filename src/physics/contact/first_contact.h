// First contact: what terrain a ball meets first, in flight or along a track.
#pragma once

#include <algorithm>
#include <cmath>

#include "physics/motion/leg.h"
#include "physics/terrain/terrain.h"

namespace physics {

// Nearer than this a ball touches: what it closes on it meets at once, what it leaves it has left. m, docs/levels.md.
inline constexpr double touch_reach = 1e-9;

// Rates of a gap below this share of the speeds, and its second derivatives below this share of the accelerations, are
// rounding; and so is what the rounding of the place itself makes of the normal's direction.
inline constexpr double rate_rounding = 1e-12;
inline constexpr double bend_rounding = 1e-13;
inline double place_rounding(Vec2 const& centre, double radius) {
    return 4.5e-16 * std::max(std::abs(centre.x()), std::abs(centre.y())) / radius;
}
// The speed along a normal below which a ball neither closes nor parts, m/s. A search for contacts is twice as lenient
// as the judgement of a contact: what the one finds to close, the other does too.
inline double still_speed(Vec2 const& centre, double radius, double speed, double pull) {
    return (rate_rounding + place_rounding(centre, radius)) * (speed + std::sqrt(pull * radius));
}

// A gap that closes but opens again before it is deeper than this has not closed, m: some roundings of the place. A
// search for contacts is twice as lenient, and four times where a gap opens and closes again.
inline double least_dip(Vec2 const& centre) {
    return 1e-15 + 9e-16 * std::max(std::abs(centre.x()), std::abs(centre.y()));
}
// How deep a gap of 0 with this rate (m/s, closing below 0) and this second derivative (m/s^2) becomes, m.
inline double dip_of(double rate, double bend) { return bend > 0 ? rate * rate / (2 * bend) : never; }

// c(t) = position + velocity t + acceleration t^2 / 2.
struct Parabola {
    Vec2 position = Vec2::Zero();
    Vec2 velocity = Vec2::Zero();
    Vec2 acceleration = Vec2::Zero();
};

struct SweepHit {
    double time = never;  // s since the search began; along a track, m of way
    Contact contact;
};

// The first terrain that a ball meets within `until` (may be infinite) other than the feature `own`, if not -1. What is
// met later than `enough` may be left out; what is found does not hang on it.
//
// A gap is the distance from the ball's rim to a piece. What is met is decided by gap and rate alone: a gap that is
// closed, within touch_reach, and closes is met at once; one that is closed and opens, or stays, is met when it closes
// again. docs/physics.md 12.3 argues why nothing is left out.
SweepHit first_contact(Terrain const& terrain, Parabola const& path, double radius, double until, int own = -1,
                       double enough = never);

// The same for flight on the drag spring, between `from` and `until` seconds (finite) after the leg began.
SweepHit first_contact(Terrain const& terrain, SpringFlight const& flight, double radius, double from, double until);

// The same for a ball that follows a circular track from q, forwards (+1) or backwards (-1), within `until` metres, at
// most one turn.
SweepHit first_contact(Terrain const& terrain, Track const& circle, double q, int direction, double radius,
                       double until, int own, double enough = never);

}  // namespace physics
