#include "physics/steps/contact_island.h"

#include <algorithm>
#include <cmath>

#include "physics/steps/stepping.h"
#include "physics/steps/firm_contacts.h"
#include "physics/steps/lone_balls.h"
#include "physics/steps/mass_scaling.h"

namespace physics {

using geometry::length;

namespace {

constexpr double near_ground = 0.02;    // share of the radius: nearer ground is watched beforehand
constexpr double standing = 1e-4;       // m/s: leaning balls slower than this are at rest
constexpr double longest_stride = 0.2;  // share of the radius: faster balls are swept through the terrain

SolverBody body_of(BodyState const& body_state, double swell) {
    Ball const& ball = *body_state.ball;
    SolverBody body;
    body.position = body_state.state.position;
    body.velocity = body_state.state.velocity;
    body.rim = ball.radius * body_state.state.spin;
    body.radius = ball.radius;
    body.inverse_mass = 1 / (swell * ball.mass);
    body.inverse_inertia = body.inverse_mass / ball.inertia;
    return body;
}

// Bodies as the substep finds them, pulled on by what acts on them.
void set_out(StepContext& context, double h) {
    for (int const i : context.island.balls) {
        BodyState const& body_state = context.body_states[i];
        SolverBody& body = context.island.bodies[i + 1];
        State const& state = body_state.state;
        body.position = state.position;
        body.velocity = flight_in(*body_state.field, state.position, state.velocity, h).velocity;
        body.rim = body.radius * state.spin;
    }
}

// What each ball touches or is about to touch, with the impulse that it had there in the last substep.
void look_at_ground(StepContext& context, Softness const& softness, double h) {
    ContactIsland& island = context.island;
    std::vector<CachedContact> const before = std::move(island.cached_contacts);
    auto known = before.begin();
    island.cached_contacts.clear();
    island.ground.clear();
    for (int const i : island.balls) {
        BodyState& body_state = context.body_states[i];
        SolverBody const& body = island.bodies[i + 1];
        double const watch = near_ground * body.radius + h * length(body.velocity);
        while (known != before.end() && known->ball < i) ++known;
        for (Shape const& shape : shapes_on_the_way(context.scene.terrain, body.position,
                                                    body.position + h * body.velocity, body.radius, body_state.near)) {
            Proximity const proximity = proximity_of(context.scene.terrain, shape, body.position);
            double const gap = proximity.distance - body.radius;
            if (!proximity.faces || gap > watch) continue;
            if (gap < -too_deep * body.radius && (island.deep.empty() || island.deep.back() != i))
                island.deep.push_back(i);
            SoftContact contact = contact_between(island.bodies[0], body, shape.material->friction);
            contact.second = i + 1;
            CachedContact touch{i, {shape.feature, proximity.side}, {}};
            for (auto old = known; old != before.end() && old->ball == i; ++old)
                if (old->contact == touch.contact) contact.impulse = old->impulse;
            place(contact, proximity.normal, gap, push_out * body.radius, softness, 1 / h);
            island.ground.push_back(contact);
            island.cached_contacts.push_back(touch);
        }
    }
}

void look_at_pairs(ContactIsland& island, Softness const& softness, double h) {
    double const per_substep = 1 / h;
    for (SoftContact& c : island.contacts)
        place(c, island.bodies[c.first], island.bodies[c.second], softness, per_substep);
}

void move_on(StepContext& context, Substep const& substep) {
    double const h = substep.length;
    for (int const i : context.island.balls) {
        BodyState& body_state = context.body_states[i];
        SolverBody& body = context.island.bodies[i + 1];
        Vec2 const way = h * body.velocity;
        double const stride = longest_stride * body.radius;
        if (geometry::dot(way, way) <= stride * stride) {
            body.position += way;
            body_state.state.angle += h * (body.rim / body.radius);
            continue;
        }
        // Not the soft way: through the air, with every line on it met. What the field adds is in the velocity already.
        Vec2 const added = h * acceleration_in(*body_state.field, body_state.state.position, body_state.state.velocity);
        body_state.state.velocity = body.velocity - added;
        body_state.state.spin = body.rim / body.radius;
        sweep(context, i, substep.since, h);
        body.position = body_state.state.position;
        body.velocity = body_state.state.velocity;
        body.rim = body.radius * body_state.state.spin;
    }
}

void resist_rolling(Terrain const& terrain, CachedContact const& touch, SoftContact const& contact, SolverBody& body) {
    double const resistance = material_of(terrain, touch.contact.feature).rolling_resistance;
    double const most = resistance * contact.impulse.normal * body.inverse_inertia;
    body.rim = body.rim < 0 ? std::min(0.0, body.rim + most) : std::max(0.0, body.rim - most);
}

// Back from the solver; and whether each ball stands, and which surface bears it.
void arrive(StepContext& context) {
    ContactIsland& island = context.island;
    for (int const i : island.balls) {
        BodyState& body_state = context.body_states[i];
        SolverBody const& body = island.bodies[i + 1];
        body_state.state.position = body.position;
        body_state.state.velocity = body.velocity;
        body_state.state.spin = body.rim / body.radius;
        body_state.contact = no_contact;
        body_state.still = length(body.velocity) <= standing && std::abs(body.rim) <= standing;
    }
    double most = 0;
    int last = -1;
    for (std::size_t k = 0; k < island.cached_contacts.size(); ++k) {
        CachedContact& touch = island.cached_contacts[k];
        touch.impulse = island.ground[k].impulse;
        if (touch.ball != last) most = 0;
        last = touch.ball;
        if (touch.impulse.normal <= most) continue;
        most = touch.impulse.normal;
        context.body_states[touch.ball].contact = touch.contact;
    }
    for (std::size_t k = 0; k < island.pairs.size(); ++k)
        context.ball_pairs[island.pairs[k]].impulse = island.contacts[k].impulse;
}

}  // namespace

void gather_pile(StepContext& context) {
    ContactIsland& island = context.island;
    swell_light_balls(context);
    island.bodies.resize(context.body_states.size() + 1);
    for (BodyState const& body_state : context.body_states)
        island.bodies[body_state.index + 1] = body_of(body_state, island.swell[body_state.index]);
    island.contacts.resize(island.pairs.size());
    for (std::size_t k = 0; k < island.pairs.size(); ++k) {
        BallPair const& pair = context.ball_pairs[island.pairs[k]];
        Ball const& first = *context.body_states[pair.first].ball;
        Ball const& second = *context.body_states[pair.second].ball;
        SoftContact& contact = island.contacts[k];
        contact = contact_between(island.bodies[pair.first + 1], island.bodies[pair.second + 1],
                                  friction_between(first, second));
        contact.first = pair.first + 1;
        contact.second = pair.second + 1;
        contact.impulse = pair.impulse;
    }
    // What stands does not yield, but its contacts are as soft as before, so that falling asleep moves nothing.
    for (BodyState const& body_state : context.body_states)
        if (context.asleep[body_state.index])
            island.bodies[body_state.index + 1].inverse_mass = island.bodies[body_state.index + 1].inverse_inertia = 0;
}

void move_pile(StepContext& context, Substep const& substep) {
    ContactIsland& island = context.island;
    island.deep.clear();
    if (island.balls.empty()) return;
    double const h = substep.length;
    double const frequency = contact_frequency(1 / h);
    set_out(context, h);
    look_at_ground(context, softness_of(2 * frequency, h), h);
    look_at_pairs(island, softness_of(frequency, h), h);
    warm_start(island.ground, island.bodies);
    warm_start(island.contacts, island.bodies);
    solve(island.ground, island.bodies);
    solve(island.contacts, island.bodies);
    move_on(context, substep);
    relax(island.ground, island.bodies);
    relax(island.contacts, island.bodies);
    for (std::size_t k = 0; k < island.ground.size(); ++k)
        resist_rolling(context.scene.terrain, island.cached_contacts[k], island.ground[k],
                       island.bodies[island.ground[k].second]);
    arrive(context);
}

}  // namespace physics
