#include "physics/steps_plan.h"

#include <algorithm>
#include <cmath>

#include "physics/exact.h"
#include "physics/stepping.h"

namespace physics {

using geometry::dot;

namespace {

constexpr int most_pushes = 16;  // out of one piece after the other

void be_where(Stage& stage, World const& world, int ball, double time) {
    stage.travellers[ball].state = at(world.legs[ball], time);
    stage.travellers[ball].contact = world.legs[ball].contact;
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

void follow(Stage& stage, int ball, double time) {
    follow_plan(stage.scene, stage.world, stage.history, ball, time);
    be_where(stage, stage.world, ball, time);
}

void begin_chord(Stage& stage, int ball, double time) {
    State const& state = stage.travellers[ball].state;
    Leg& leg = stage.world.legs[ball];
    Trail<Leg>& legs = stage.history.legs[ball];
    if (legs.back().since >= time) legs.pop_back();
    if (!legs.empty()) legs.back().until = time;
    leg = {time, never, leg.phase, leg.contact, Straight{state, state.velocity, state.spin}};
    legs.push_back(leg);
}

void end_chord(Stage& stage, int ball, double time) {
    Leg const& leg = stage.world.legs[ball];
    if (leg.since < time)
        write_leg(stage.world, stage.history, ball, time, {stage.travellers[ball].state, leg.phase, leg.contact});
}

void depart(Stage& stage, int ball, double time) {
    Departure& departure = stage.departures[ball];
    departure.state = stage.travellers[ball].state;
    departure.time = time;
    if (is_stepped(stage.world, ball)) return;
    departure.leg = stage.world.legs[ball];
    departure.outlook = stage.world.outlooks[ball];
    departure.legs = stage.history.legs[ball].size();
}

void return_to_departure(Stage& stage, int ball) {
    Departure const& departure = stage.departures[ball];
    Trail<Leg>& legs = stage.history.legs[ball];
    while (legs.size() > departure.legs) legs.pop_back();
    legs.back() = departure.leg;
    stage.world.legs[ball] = departure.leg;
    stage.world.outlooks[ball] = departure.outlook;
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
bool is_free(Terrain const& terrain, Traveller& traveller, Flight const& end, double span) {
    Vec2 const& from = traveller.state.position;
    double const reach =
        traveller.ball->radius + span * (geometry::length(traveller.state.velocity) + geometry::length(end.velocity));
    auto const& shapes = shapes_on_the_way(terrain, from, end.position, traveller.ball->radius, traveller.near);
    return std::none_of(shapes.begin(), shapes.end(), [&](Shape const& shape) {
        Sight const sight = sight_of(terrain, shape, from);
        return sight.faces && sight.distance <= reach;
    });
}

}  // namespace

void sweep(Stage& stage, int ball, double time, double span) {
    Traveller& traveller = stage.travellers[ball];
    Flight const end = flight_in(*traveller.field, traveller.state.position, traveller.state.velocity, span);
    if (is_free(stage.scene.terrain, traveller, end, span)) {
        traveller.state = {end.position, end.velocity, traveller.state.angle + span * traveller.state.spin,
                           traveller.state.spin};
        traveller.contact = no_contact;
        return;
    }
    stage.alone_world.forces = stage.world.forces;
    stage.alone_world.legs.resize(stage.travellers.size());
    stage.alone_world.outlooks.resize(stage.travellers.size());
    stage.alone_history.legs.resize(stage.travellers.size());
    stage.alone_history.legs[ball].clear();
    stage.alone_history.events.clear();
    set_out(stage.scene, stage.alone_world, stage.alone_history, ball, stage.travellers[ball].state, no_contact, time);
    follow_plan(stage.scene, stage.alone_world, stage.alone_history, ball, time + span);
    be_where(stage, stage.alone_world, ball, time + span);
}

}  // namespace physics
