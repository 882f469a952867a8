#include "physics/steps_pile.h"

#include <algorithm>
#include <cmath>

#include "physics/stepping.h"
#include "physics/steps_firm.h"
#include "physics/steps_plan.h"
#include "physics/steps_swell.h"

namespace physics {

using geometry::length;

namespace {

constexpr double near_ground = 0.02;    // share of the radius: nearer ground is watched beforehand
constexpr double standing = 1e-4;       // m/s: leaning balls slower than this are at rest
constexpr double longest_stride = 0.2;  // share of the radius: faster balls are swept through the terrain

Body body_of(Traveller const& traveller, double swell) {
    Ball const& ball = *traveller.ball;
    Body body;
    body.position = traveller.state.position;
    body.velocity = traveller.state.velocity;
    body.rim = ball.radius * traveller.state.spin;
    body.radius = ball.radius;
    body.yield = 1 / (swell * ball.mass);
    body.turn = body.yield / ball.inertia;
    return body;
}

// Bodies as the substep finds them, pulled on by what acts on them.
void set_out(Stage& stage, double h) {
    for (int const i : stage.pile.balls) {
        Traveller const& traveller = stage.travellers[i];
        Body& body = stage.pile.bodies[i + 1];
        State const& state = traveller.state;
        body.position = state.position;
        body.velocity = flight_in(*traveller.field, state.position, state.velocity, h).velocity;
        body.rim = body.radius * state.spin;
    }
}

// What each ball touches or is about to touch, with the impulse that it had there in the last substep.
void look_at_ground(Stage& stage, Softness const& softness, double h) {
    Pile& pile = stage.pile;
    std::vector<Touch> const before = std::move(pile.touches);
    auto known = before.begin();
    pile.touches.clear();
    pile.ground.clear();
    for (int const i : pile.balls) {
        Traveller& traveller = stage.travellers[i];
        Body const& body = pile.bodies[i + 1];
        double const watch = near_ground * body.radius + h * length(body.velocity);
        while (known != before.end() && known->ball < i) ++known;
        for (Shape const& shape :
             shapes_on_the_way(stage.scene.terrain, body.position, body.position + h * body.velocity, body.radius,
                               traveller.near)) {
            Sight const sight = sight_of(stage.scene.terrain, shape, body.position);
            double const gap = sight.distance - body.radius;
            if (!sight.faces || gap > watch) continue;
            if (gap < -too_deep * body.radius && (pile.deep.empty() || pile.deep.back() != i)) pile.deep.push_back(i);
            SoftContact contact = contact_between(pile.bodies[0], body, shape.material->friction);
            contact.second = i + 1;
            Touch touch{i, {shape.feature, sight.side}, {}};
            for (auto old = known; old != before.end() && old->ball == i; ++old)
                if (old->contact == touch.contact) contact.impulse = old->impulse;
            place(contact, sight.normal, gap, push_out * body.radius, softness, 1 / h);
            pile.ground.push_back(contact);
            pile.touches.push_back(touch);
        }
    }
}

void look_at_pairs(Pile& pile, Softness const& softness, double h) {
    double const per_substep = 1 / h;
    for (SoftContact& c : pile.contacts) place(c, pile.bodies[c.first], pile.bodies[c.second], softness, per_substep);
}

void move_on(Stage& stage, Substep const& substep) {
    double const h = substep.length;
    for (int const i : stage.pile.balls) {
        Traveller& traveller = stage.travellers[i];
        Body& body = stage.pile.bodies[i + 1];
        Vec2 const way = h * body.velocity;
        double const stride = longest_stride * body.radius;
        if (geometry::dot(way, way) <= stride * stride) {
            body.position += way;
            traveller.state.angle += h * (body.rim / body.radius);
            continue;
        }
        // Not the soft way: through the air, with every line on it met. What the field adds is in the velocity already.
        Vec2 const added = h * acceleration_in(*traveller.field, traveller.state.position, traveller.state.velocity);
        traveller.state.velocity = body.velocity - added;
        traveller.state.spin = body.rim / body.radius;
        sweep(stage, i, substep.since, h);
        body.position = traveller.state.position;
        body.velocity = traveller.state.velocity;
        body.rim = body.radius * traveller.state.spin;
    }
}

void resist_rolling(Terrain const& terrain, Touch const& touch, SoftContact const& contact, Body& body) {
    double const resistance = material_of(terrain, touch.contact.feature).rolling_resistance;
    double const most = resistance * contact.impulse.normal * body.turn;
    body.rim = body.rim < 0 ? std::min(0.0, body.rim + most) : std::max(0.0, body.rim - most);
}

// Back from the solver; and whether each ball stands, and which surface bears it.
void arrive(Stage& stage) {
    Pile& pile = stage.pile;
    for (int const i : pile.balls) {
        Traveller& traveller = stage.travellers[i];
        Body const& body = pile.bodies[i + 1];
        traveller.state.position = body.position;
        traveller.state.velocity = body.velocity;
        traveller.state.spin = body.rim / body.radius;
        traveller.contact = no_contact;
        traveller.still = length(body.velocity) <= standing && std::abs(body.rim) <= standing;
    }
    double most = 0;
    int last = -1;
    for (std::size_t k = 0; k < pile.touches.size(); ++k) {
        Touch& touch = pile.touches[k];
        touch.impulse = pile.ground[k].impulse;
        if (touch.ball != last) most = 0;
        last = touch.ball;
        if (touch.impulse.normal <= most) continue;
        most = touch.impulse.normal;
        stage.travellers[touch.ball].contact = touch.contact;
    }
    for (std::size_t k = 0; k < pile.pairs.size(); ++k)
        stage.neighbours[pile.pairs[k]].impulse = pile.contacts[k].impulse;
}

}  // namespace

void gather_pile(Stage& stage) {
    Pile& pile = stage.pile;
    swell_light_balls(stage);
    pile.bodies.resize(stage.travellers.size() + 1);
    for (Traveller const& traveller : stage.travellers)
        pile.bodies[traveller.index + 1] = body_of(traveller, pile.swell[traveller.index]);
    pile.contacts.resize(pile.pairs.size());
    for (std::size_t k = 0; k < pile.pairs.size(); ++k) {
        Neighbours const& pair = stage.neighbours[pile.pairs[k]];
        Ball const& first = *stage.travellers[pair.first].ball;
        Ball const& second = *stage.travellers[pair.second].ball;
        SoftContact& contact = pile.contacts[k];
        contact =
            contact_between(pile.bodies[pair.first + 1], pile.bodies[pair.second + 1], friction_between(first, second));
        contact.first = pair.first + 1;
        contact.second = pair.second + 1;
        contact.impulse = pair.impulse;
    }
    // What stands does not yield, but its contacts are as soft as before, so that falling asleep moves nothing.
    for (Traveller const& traveller : stage.travellers)
        if (stage.asleep[traveller.index])
            pile.bodies[traveller.index + 1].yield = pile.bodies[traveller.index + 1].turn = 0;
}

void move_pile(Stage& stage, Substep const& substep) {
    Pile& pile = stage.pile;
    pile.deep.clear();
    if (pile.balls.empty()) return;
    double const h = substep.length;
    double const frequency = contact_frequency(1 / h);
    set_out(stage, h);
    look_at_ground(stage, softness_of(2 * frequency, h), h);
    look_at_pairs(pile, softness_of(frequency, h), h);
    warm(pile.ground, pile.bodies);
    warm(pile.contacts, pile.bodies);
    press(pile.ground, pile.bodies);
    press(pile.contacts, pile.bodies);
    move_on(stage, substep);
    hold(pile.ground, pile.bodies);
    hold(pile.contacts, pile.bodies);
    for (std::size_t k = 0; k < pile.ground.size(); ++k)
        resist_rolling(stage.scene.terrain, pile.touches[k], pile.ground[k], pile.bodies[pile.ground[k].second]);
    arrive(stage);
}

}  // namespace physics
