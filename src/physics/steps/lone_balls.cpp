#include "physics/steps/lone_balls.h"

#include <algorithm>
#include <cmath>

#include "physics/plan/planned_balls.h"
#include "physics/steps/stepping.h"

namespace physics {

using geometry::dot;

namespace {

constexpr int most_pushes = 16;      // out of one piece after the other
constexpr double spans_planned = 2;  // of a swept ball: one, and as much again, as the end of the first is rounded

void be_where(StepContext& context, World const& world, int ball, double time) {
    context.body_states[ball].state = at(world.legs[ball], time);
    context.body_states[ball].contact = world.legs[ball].contact;
}

State on_track(Scene const& scene, World const& world, int ball, State const& state, Contact contact) {
    Track const track = track_of(scene.terrain, contact, scene.balls[ball].radius);
    double const q = nearest_coordinate(track, state.position);
    Vec2 const along = geometry::turned_right(normal_at(track, q));
    State put = state;
    put.position = position_at(track, q);
    double const speed = dot(state.velocity, along);
    double const lifted = -dot(gravity_of(scene, world.forces), put.position - state.position);
    double const yield = 1 + scene.balls[ball].inertia;
    double const square = speed * speed - std::max(0.0, 2 * lifted / yield);
    double const kept = square > 0 ? std::copysign(std::sqrt(square), speed) : 0;
    put.velocity = kept * along;
    if (world.legs[ball].phase != Phase::slide) put.spin = -kept / scene.balls[ball].radius;
    return put;
}

// Out of the piece that the ball is deepest in; false if it is in none.
bool pushed_out(Terrain const& terrain, Vec2& centre, double radius) {
    double deepest = touch_reach;
    Vec2 way = Vec2::Zero();
    Vec2 const reach = Vec2::Constant(radius);
    terrain.tree.each_overlapping({centre - reach, centre + reach}, [&](int piece) {
        geometry::Nearest const nearest = geometry::nearest_point(terrain.pieces[piece].curve, centre);
        double const depth = radius - nearest.distance;
        if (depth <= deepest || nearest.distance == 0) return;
        deepest = depth;
        way = (depth / nearest.distance) * (centre - nearest.point);
    });
    centre += way;
    return way != Vec2::Zero();
}

}  // namespace

void follow(StepContext& context, int ball, double time) {
    follow_plan(context.scene, context.world, context.history, ball, time);
    be_where(context, context.world, ball, time);
}

void begin_chord(StepContext& context, int ball, double time) {
    State const& state = context.body_states[ball].state;
    Leg& leg = context.world.legs[ball];
    Trail<Leg>& legs = context.history.legs[ball];
    if (legs.back().since >= time) legs.pop_back();
    if (!legs.empty()) legs.back().until = time;
    leg = {time, never, leg.phase, leg.contact, Straight{state, state.velocity, state.spin}};
    legs.push_back(leg);
}

void end_chord(StepContext& context, int ball, double time) {
    Leg const& leg = context.world.legs[ball];
    if (leg.since < time)
        write_leg(context.world, context.history, ball, time,
                  {context.body_states[ball].state, leg.phase, leg.contact});
}

void depart(StepContext& context, int ball, double time, double until) {
    Departure& departure = context.departures[ball];
    departure.state = context.body_states[ball].state;
    departure.time = time;
    departure.keeps_plan = is_stepped(context.world, ball) || context.world.legs[ball].until > until;
    if (departure.keeps_plan) return;
    departure.leg = context.world.legs[ball];
    departure.plan = context.world.plans[ball];
    departure.legs = context.history.legs[ball].size();
}

void return_to_departure(StepContext& context, int ball) {
    Departure const& departure = context.departures[ball];
    if (departure.keeps_plan) return;
    Trail<Leg>& legs = context.history.legs[ball];
    while (legs.size() > departure.legs) legs.pop_back();
    legs.back() = departure.leg;
    context.world.legs[ball] = departure.leg;
    context.world.plans[ball] = departure.plan;
}

void release(Scene const& scene, World& world, History& history, int ball, double time) {
    double const radius = scene.balls[ball].radius;
    State state = at(world.legs[ball], time);
    Contact contact = world.legs[ball].contact;
    if (contact.feature >= 0 && !fits(scene.terrain, contact, radius)) contact = no_contact;
    if (contact.feature >= 0) state = on_track(scene, world, ball, state, contact);
    for (int i = 0; i < most_pushes && pushed_out(scene.terrain, state.position, radius); ++i) contact = no_contact;
    set_out(scene, world, history, ball, state, contact, time);
}

namespace {

// Whether the ball comes nowhere near terrain on the way of the flight.
bool is_free(Terrain const& terrain, BodyState& body_state, Flight const& end, double span) {
    Vec2 const& from = body_state.state.position;
    double const reach =
        body_state.ball->radius + span * (geometry::length(body_state.state.velocity) + geometry::length(end.velocity));
    auto const& shapes = shapes_on_the_way(terrain, from, end.position, body_state.ball->radius, body_state.near);
    return std::none_of(shapes.begin(), shapes.end(), [&](Shape const& shape) {
        Proximity const proximity = proximity_of(terrain, shape, from);
        return proximity.faces && proximity.distance <= reach;
    });
}

}  // namespace

void sweep(StepContext& context, int ball, double time, double span) {
    BodyState& body_state = context.body_states[ball];
    Flight const end = flight_in(*body_state.field, body_state.state.position, body_state.state.velocity, span);
    if (is_free(context.scene.terrain, body_state, end, span)) {
        body_state.state = {end.position, end.velocity, body_state.state.angle + span * body_state.state.spin,
                            body_state.state.spin};
        body_state.contact = no_contact;
        return;
    }
    context.alone_world.forces = context.world.forces;
    context.alone_world.legs.resize(context.body_states.size());
    context.alone_world.plans.resize(context.body_states.size());
    context.alone_history.legs.resize(context.body_states.size());
    context.alone_history.legs[ball].clear();
    context.alone_history.events.clear();
    set_out(context.scene, context.alone_world, context.alone_history, ball, context.body_states[ball].state,
            no_contact, time, spans_planned * span);
    follow_plan(context.scene, context.alone_world, context.alone_history, ball, time + span);
    be_where(context, context.alone_world, ball, time + span);
}

}  // namespace physics
