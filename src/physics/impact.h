// Impacts: what a blow does to a ball that meets terrain, and to two balls that meet (physics.md 1).
#pragma once

#include "physics/ball.h"

namespace physics {

// Motion at a contact: speed along the normal, along the tangent, and of the rim in the rolling sense, s = -r w. m/s.
struct ContactSpeeds {
    double normal = 0;
    double tangent = 0;
    double rim = 0;
    double slip() const { return tangent - rim; }
};

// After an impact with restitution e and friction mu; a stick leaves rim == tangent to the bit. `inertia` is k.
ContactSpeeds after_impact(ContactSpeeds const& before, double restitution, double friction, double inertia);

// Whether the impact stops the slip: |u| k/(1+k) <= mu (1+e) |v_n|.
bool sticks(ContactSpeeds const& before, double restitution, double friction, double inertia);

// Friction of ball against ball: the tangential impulse (N s) that ends the slip, as far as goes with a normal one of
// `normal_impulse` along the unit normal from a to b, of which `so_far` has been given to these states already. Along
// t = (n.y, -n.x): on a it acts against t, on b along it.
double pair_friction_impulse(Ball const& a, State const& at_a, Ball const& b, State const& at_b, Vec2 const& normal,
                             double normal_impulse, double so_far);

// Impulses (N s) act on a backwards and on b forwards; both spins turn the same way.
void push_apart(Ball const& a, State& at_a, Ball const& b, State& at_b, Vec2 const& normal, double normal_impulse,
                double tangent_impulse);

}  // namespace physics
