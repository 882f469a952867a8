// Soft contacts of balls that lean on each other: what the innermost loops of the stepping method read and write.
#pragma once

#include <vector>

#include "physics/steps/ball_impacts.h"

namespace physics {

// A ball as its contacts see it. Terrain is one that nothing moves.
struct SolverBody {
    Vec2 position = Vec2::Zero();  // m
    Vec2 velocity = Vec2::Zero();  // m/s
    double rim = 0;                // m/s, the radius times the spin
    double radius = 0;             // m
    double inverse_mass = 0;       // 1/kg, 0 for what nothing moves
    double inverse_inertia = 0;    // 1/kg, the yield over k
};

// How soft a constraint of a frequency is over a substep (E. Catto, Solver2D).
struct Softness {
    double bias_rate = 0;  // 1/s
    double mass_scale = 1;
    double impulse_scale = 0;
};
Softness softness_of(double frequency, double substep);

struct SoftContact {
    int first = 0, second = 0;   // bodies; the normal points to the second
    Vec2 normal = Vec2::Zero();  // unit
    double normal_mass = 0;      // kg
    double tangent_mass = 0;     // kg
    double friction = 0;         // finite
    double mass = 0;             // kg, what answers a closing speed, softened
    double bias = 0;             // m/s, how fast an overlap is pushed out (negative), or a gap may close
    double forgetting = 0;       // share of its impulse that a soft contact gives back
    double allowed = 0;          // m/s, how fast a gap may close
    Impulse impulse;             // N s
};
SoftContact contact_between(SolverBody const& first, SolverBody const& second, double friction);

// Where the contact is at the substep's beginning; `gap` is negative where the two overlap.
void place(SoftContact& contact, Vec2 const& normal, double gap, double most_push, Softness const& softness,
           double per_substep);
// The same between two balls.
void place(SoftContact& contact, SolverBody const& first, SolverBody const& second, Softness const& softness,
           double per_substep);

// Starts from the impulses of the substep before.
void warm_start(std::vector<SoftContact> const& contacts, std::vector<SolverBody>& bodies);
// Stops closing and slip, and pushes overlaps out.
void solve(std::vector<SoftContact>& contacts, std::vector<SolverBody>& bodies);
// Only stops them, so that the speed of pushing out does not stay.
void relax(std::vector<SoftContact>& contacts, std::vector<SolverBody>& bodies);

inline constexpr double push_out = 8;  // radii a second at which an overlap is pushed out at most

}  // namespace physics
