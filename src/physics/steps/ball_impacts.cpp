#include "physics/steps/ball_impacts.h"

#include <algorithm>

namespace physics {

using geometry::dot;

PairImpact after_pair_impact(State const& first, Ball const& one, State const& second, Ball const& other,
                             Vec2 const& normal, double restitution) {
    Vec2 const tangent = geometry::turned_right(normal);
    Vec2 const relative = second.velocity - first.velocity;
    double const slip = dot(relative, tangent) + one.radius * first.spin + other.radius * second.spin;
    double const normal_yield = 1 / one.mass + 1 / other.mass;
    double const tangent_yield = (1 + 1 / one.inertia) / one.mass + (1 + 1 / other.inertia) / other.mass;
    PairImpact impact{first, second, {}};
    impact.impulse.normal = std::max(0.0, -(1 + restitution) * dot(relative, normal) / normal_yield);
    impact.impulse.tangent = within_grip(-slip / tangent_yield, friction_between(one, other), impact.impulse.normal);
    Vec2 const push = impact.impulse.normal * normal + impact.impulse.tangent * tangent;
    impact.first.velocity -= push / one.mass;
    impact.second.velocity += push / other.mass;
    impact.first.spin += impact.impulse.tangent / (one.inertia * one.mass * one.radius);
    impact.second.spin += impact.impulse.tangent / (other.inertia * other.mass * other.radius);
    return impact;
}

}  // namespace physics
