// Times of impact: when two balls meet, and the blow when they do, for several pairs at once.
#pragma once

#include <vector>

#include "physics/world/world.h"

namespace physics {

struct TimeOfImpact {
    double time = never;  // s, when they meet; or until when it is certain that they do not
    bool meets = false;
    bool presses = false;  // they touch without closing, and are pushed together: no blow can settle that
};

// The first time in [from, until] at which two balls at a distance of `reach` between centres close on each other.
// Quadratic paths by the quartic's roots, others by conservative advancement (physics.md 8.1, 8.2), for which the
// search may end before `until`.
TimeOfImpact time_of_impact(Leg const& a, Leg const& b, double reach, double from, double until);

struct Pair {
    int a = 0, b = 0;
};

// Blows of all pairs at once: normal speeds are reversed by each pair's restitution, solved together, so that the order
// of the balls does not matter; then friction, likewise (physics.md 8.3). States by ball.
void solve_simultaneous_impacts(std::vector<Ball> const& balls, std::vector<Pair> const& pairs,
                                std::vector<State>& states);

// How fast the balls close on each other (m/s), negative when they part.
double closing_speed(State const& a, State const& b);

}  // namespace physics
