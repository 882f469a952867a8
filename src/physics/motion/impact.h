// Impacts: what a blow does to a ball that meets terrain, and to two balls that meet (physics.md 1.2, 1.3).
#pragma once

#include <algorithm>
#include <cmath>

#include "physics/motion/ball.h"

namespace physics {

// Motion at a contact: speed along the normal, along the tangent, and of the rim in the rolling sense, s = -r w. m/s.
struct ContactSpeeds {
    double normal = 0;
    double tangent = 0;
    double rim = 0;
    double slip() const { return tangent - rim; }
};

// Whether the impact stops the slip: |u| k/(1+k) <= mu (1+e) |v_n|.
inline bool sticks(ContactSpeeds const& before, double restitution, double friction, double inertia) {
    return std::abs(before.slip()) * inertia / (1 + inertia) <= friction * (1 + restitution) * -before.normal;
}

// After an impact with restitution e and friction mu; a stick leaves rim == tangent to the bit. `inertia` is k.
inline ContactSpeeds after_impact(ContactSpeeds const& before, double restitution, double friction, double inertia) {
    ContactSpeeds after = before;
    after.normal = -restitution * before.normal;
    // Without normal impulse there is no friction, infinite or not.
    if (before.slip() == 0 || before.normal == 0) return after;
    if (sticks(before, restitution, friction, inertia)) {
        after.tangent = (before.tangent + inertia * before.rim) / (1 + inertia);
        after.rim = after.tangent;
        return after;
    }
    double const impulse = -std::copysign(friction * (1 + restitution) * before.normal, before.slip());
    after.tangent += impulse;
    after.rim -= impulse / inertia;
    return after;
}

// A tangential impulse (N s) as far as friction carries it. Without a normal impulse there is none, be friction
// infinite or not.
inline double within_grip(double wanted, double friction, double normal_impulse) {
    if (!(normal_impulse > 0)) return 0;
    double const most = friction * normal_impulse;
    return std::clamp(wanted, -most, most);
}

// Ball against ball (docs/levels.md).
double friction_between(Ball const& a, Ball const& b);
double restitution_between(Ball const& a, Ball const& b);

// Friction of ball against ball: the tangential impulse (N s) that ends the slip, as far as goes with a normal one of
// `normal_impulse` along the unit normal from a to b, of which `so_far` has been given to these states already. Along
// t = (n.y, -n.x): on a it acts against t, on b along it.
double pair_friction_impulse(Ball const& a, State const& at_a, Ball const& b, State const& at_b, Vec2 const& normal,
                             double normal_impulse, double so_far);

// Impulses (N s) act on a backwards and on b forwards; both spins turn the same way.
void push_apart(Ball const& a, State& at_a, Ball const& b, State& at_b, Vec2 const& normal, double normal_impulse,
                double tangent_impulse);

}  // namespace physics
