#include "physics/motion/impact.h"

#include <algorithm>
#include <cmath>

namespace physics {

double friction_between(Ball const& a, Ball const& b) {
    // Frictionless wins over full grip: 0 times infinity is no number.
    if (a.friction == 0 || b.friction == 0) return 0;
    if (a.friction == b.friction) return a.friction;
    // The product of the two might be too great a number.
    return std::sqrt(a.friction) * std::sqrt(b.friction);
}

double restitution_between(Ball const& a, Ball const& b) { return std::max(a.restitution, b.restitution); }

double pair_friction_impulse(Ball const& a, State const& at_a, Ball const& b, State const& at_b, Vec2 const& normal,
                             double normal_impulse, double so_far) {
    Vec2 const tangent = geometry::turned_right(normal);
    double const slip =
        geometry::dot(at_b.velocity - at_a.velocity, tangent) + at_a.spin * a.radius + at_b.spin * b.radius;
    double const yield = (1 + 1 / a.inertia) / a.mass + (1 + 1 / b.inertia) / b.mass;
    return within_grip(so_far - slip / yield, friction_between(a, b), normal_impulse);
}

void push_apart(Ball const& a, State& at_a, Ball const& b, State& at_b, Vec2 const& normal, double normal_impulse,
                double tangent_impulse) {
    Vec2 const impulse = normal_impulse * normal + tangent_impulse * geometry::turned_right(normal);
    at_a.velocity -= impulse / a.mass;
    at_b.velocity += impulse / b.mass;
    at_a.spin += tangent_impulse / (a.inertia * a.mass * a.radius);
    at_b.spin += tangent_impulse / (b.inertia * b.mass * b.radius);
}

}  // namespace physics
