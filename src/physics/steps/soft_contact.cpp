#include "physics/steps/soft_contact.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"

namespace physics {

using geometry::dot;

namespace {

constexpr double damping = 10;     // of critical: overlaps are pushed out without a bounce
constexpr double most_grip = 1e9;  // friction beyond is none the firmer, and infinity times nothing is no number

void push(SoftContact const& c, double normal, double tangent, SolverBody& first, SolverBody& second) {
    Vec2 const impulse = normal * c.normal + tangent * geometry::turned_right(c.normal);
    first.velocity -= first.inverse_mass * impulse;
    second.velocity += second.inverse_mass * impulse;
    first.rim += first.inverse_inertia * tangent;
    second.rim += second.inverse_inertia * tangent;
}

// Normal and tangent impulses do not disturb each other at one contact (physics.md 1.2): both answer the same speeds.
void solve(SoftContact& c, double mass, double bias, double forgetting, std::vector<SolverBody>& bodies) {
    SolverBody& first = bodies[c.first];
    SolverBody& second = bodies[c.second];
    Vec2 const relative = second.velocity - first.velocity;
    double const closing = dot(relative, c.normal);
    double const slip = dot(relative, geometry::turned_right(c.normal)) + (first.rim + second.rim);
    double const kept = c.impulse.normal - forgetting * c.impulse.normal;
    double const normal = std::max(0.0, kept - mass * (closing + bias));
    double const most = c.friction * normal;
    double const tangent = std::max(-most, std::min(most, c.impulse.tangent - c.tangent_mass * slip));
    push(c, normal - c.impulse.normal, tangent - c.impulse.tangent, first, second);
    c.impulse = {normal, tangent};
}

}  // namespace

Softness softness_of(double frequency, double substep) {
    double const omega = 2 * geometry::pi * frequency;
    double const a1 = 2 * damping + substep * omega;
    double const a2 = substep * omega * a1;
    return {omega / a1, a2 / (1 + a2), 1 / (1 + a2)};
}

SoftContact contact_between(SolverBody const& first, SolverBody const& second, double friction) {
    double const inverse_mass = first.inverse_mass + second.inverse_mass;
    SoftContact contact;
    contact.normal_mass = 1 / inverse_mass;
    contact.tangent_mass = 1 / (inverse_mass + (first.inverse_inertia + second.inverse_inertia));
    contact.friction = std::min(friction, most_grip);
    return contact;
}

void place(SoftContact& contact, Vec2 const& normal, double gap, double most_push, Softness const& softness,
           double per_substep) {
    bool const open = gap > 0;
    contact.normal = normal;
    contact.allowed = open ? gap * per_substep : 0;
    contact.bias = open ? contact.allowed : std::max(softness.bias_rate * gap, -most_push);
    contact.mass = open ? contact.normal_mass : softness.mass_scale * contact.normal_mass;
    contact.forgetting = open ? 0 : softness.impulse_scale;
}

void place(SoftContact& contact, SolverBody const& first, SolverBody const& second, Softness const& softness,
           double per_substep) {
    Vec2 const d = second.position - first.position;
    double const distance = geometry::length(d);
    Vec2 const normal = distance > 0 ? Vec2(d * (1 / distance)) : Vec2(0, 1);
    double const most_push = push_out * std::min(first.radius, second.radius);
    place(contact, normal, distance - (first.radius + second.radius), most_push, softness, per_substep);
}

void warm_start(std::vector<SoftContact> const& contacts, std::vector<SolverBody>& bodies) {
    for (SoftContact const& c : contacts)
        push(c, c.impulse.normal, c.impulse.tangent, bodies[c.first], bodies[c.second]);
}

void solve(std::vector<SoftContact>& contacts, std::vector<SolverBody>& bodies) {
    for (SoftContact& c : contacts) solve(c, c.mass, c.bias, c.forgetting, bodies);
}

void relax(std::vector<SoftContact>& contacts, std::vector<SolverBody>& bodies) {
    for (SoftContact& c : contacts) solve(c, c.normal_mass, c.allowed, 0, bodies);
}

}  // namespace physics
