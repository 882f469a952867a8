#include "physics/impact.h"

#include <algorithm>
#include <cmath>

namespace physics {

double pair_friction_impulse(Ball const& a, State const& at_a, Ball const& b, State const& at_b, Vec2 const& normal,
                             double normal_impulse, double so_far) {
    Vec2 const tangent = geometry::turned_right(normal);
    double const slip =
        geometry::dot(at_b.velocity - at_a.velocity, tangent) + at_a.spin * a.radius + at_b.spin * b.radius;
    double const yield = (1 + 1 / a.inertia) / a.mass + (1 + 1 / b.inertia) / b.mass;
    double const limit = std::sqrt(a.friction * b.friction) * normal_impulse;
    return std::clamp(so_far - slip / yield, -limit, limit);
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
