// A ball pressed against two surfaces at once: the impulses of both, found together (physics.md 2.12).
#include <algorithm>
#include <cmath>

#include "physics/steps_travel.h"

namespace physics {

using geometry::dot;

namespace {

constexpr int most_rounds = 100;   // over both contacts; a narrow groove converges slowly
constexpr double settled = 1e-13;  // share of the impulses by which the last round may still change them
constexpr double wedge_standing = 1e-7;  // m/s

// One of the two contacts with the impulses gathered so far, per unit mass.
struct Hold {
    Vec2 normal = Vec2::Zero();
    Vec2 tangent = Vec2::Zero();
    double friction = 0;
    Impulse impulse;
};

Hold hold_on(Terrain const& terrain, Shape const& shape, Vec2 const& centre) {
    Sight const sight = sight_of(terrain, shape, centre);
    return {sight.normal, geometry::turned_right(sight.normal), shape.material->friction, {}};
}

// Adds to the hold's impulses what keeps the ball from closing and slipping; answers by how much they changed.
double press(Hold& hold, State& state, Ball const& ball) {
    double const k = ball.inertia;
    Impulse const before = hold.impulse;
    hold.impulse.normal = std::max(0.0, before.normal - dot(state.velocity, hold.normal));
    state.velocity += (hold.impulse.normal - before.normal) * hold.normal;
    double const slip = dot(state.velocity, hold.tangent) + ball.radius * state.spin;
    double const most = hold.impulse.normal > 0 ? hold.friction * hold.impulse.normal : 0;
    hold.impulse.tangent = std::clamp(before.tangent - slip * k / (1 + k), -most, most);
    double const change = hold.impulse.tangent - before.tangent;
    state.velocity += change * hold.tangent;
    state.spin += change / (k * ball.radius);
    return std::abs(hold.impulse.normal - before.normal) + std::abs(change);
}

// The couple against rolling, as far as it does not turn the spin round.
double resisted(double spin, double couple) {
    return spin < 0 ? std::min(0.0, spin + couple) : std::max(0.0, spin - couple);
}

}  // namespace

void wedge_between(Substep const& substep, Traveller& traveller, Shape const& one, Shape const& other, double time) {
    if (time <= 0) return;
    State& state = traveller.state;
    Ball const& ball = *traveller.ball;
    State const before = state;
    Hold a = hold_on(substep.terrain, one, state.position), b = hold_on(substep.terrain, other, state.position);
    state.velocity = flight_in(*traveller.field, state.position, state.velocity, time).velocity;
    for (int i = 0; i < most_rounds; ++i) {
        double const change = press(a, state, ball) + press(b, state, ball);
        if (change <= settled * (a.impulse.normal + b.impulse.normal)) break;
    }
    double const resistance =
        one.material->rolling_resistance * a.impulse.normal + other.material->rolling_resistance * b.impulse.normal;
    state.spin = resisted(state.spin, resistance / (ball.inertia * ball.radius));
    state.position += (0.5 * time) * (before.velocity + state.velocity);
    state.angle += 0.5 * time * (before.spin + state.spin);
    traveller.impulse = a.impulse;
    if (a.impulse.normal == 0 && b.impulse.normal > 0) {
        Sight const sight = sight_of(substep.terrain, other, state.position);
        traveller.contact = {other.feature, sight.side};
    }
    traveller.still = geometry::length(before.velocity) <= wedge_standing && geometry::length(state.velocity) <= wedge_standing &&
                      std::abs(state.spin) * ball.radius <= wedge_standing;
}

namespace {

constexpr double rocking = 4;      // substeps' worth of acceleration: slower than this a ball only rocks
constexpr int most_seatings = 40;  // on both in turn: each leaves cos^2 of the angle between their normals of a gap
constexpr double seated = 1e-12;   // share of the radius

double gap_in(Sight const& sight, Traveller const& traveller) {
    return std::abs(sight.distance - traveller.ball->radius);
}

std::vector<Shape> shapes_within(double gap, Substep const& substep, Traveller const& traveller) {
    std::vector<Shape> near;
    for (Shape const& shape : traveller.near.shapes) {
        Sight const sight = sight_of(substep.terrain, shape, traveller.state.position);
        if (sight.faces && gap_in(sight, traveller) <= gap) near.push_back(shape);
    }
    return near;
}

// At rest on both, if they hold it.
Traveller standing_between(Substep const& substep, Traveller const& traveller, Shape const& one, Shape const& other) {
    Traveller still = traveller;
    still.state.velocity = Vec2::Zero();
    still.state.spin = 0;
    double const close = seated * traveller.ball->radius;
    Sight sight = sight_of(substep.terrain, one, still.state.position);
    for (int i = 0; i < most_seatings && gap_in(sight, still) > close; ++i) {
        seat(substep.terrain, one, still);
        seat(substep.terrain, other, still);
        sight = sight_of(substep.terrain, one, still.state.position);
    }
    still.contact = {one.feature, sight.side};
    State const there = still.state;
    wedge_between(substep, still, one, other, substep.pace);
    still.state = there;
    return still;
}

}  // namespace

void settle_between(Substep const& substep, Traveller& traveller) {
    State const& state = traveller.state;
    double const pull = geometry::length(acceleration_in(*traveller.field, state.position, Vec2::Zero()));
    double const slow = rocking * pull * substep.pace;
    if (traveller.still || geometry::length(state.velocity) > slow ||
        std::abs(state.spin) * traveller.ball->radius > slow)
        return;
    std::vector<Shape> const near = shapes_within(slow * substep.pace, substep, traveller);
    for (std::size_t i = 1; i < near.size(); ++i) {
        Vec2 const normal = sight_of(substep.terrain, near[i - 1], state.position).normal;
        if (std::abs(geometry::wedge(normal, sight_of(substep.terrain, near[i], state.position).normal)) <= joint_turn)
            continue;
        Traveller const held = standing_between(substep, traveller, near[i - 1], near[i]);
        if (!held.still) continue;
        traveller = held;
        return;
    }
}

}  // namespace physics
