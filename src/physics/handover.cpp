#include "physics/handover.h"

#include <algorithm>
#include <cmath>

#include "physics/exact.h"
#include "physics/field.h"
#include "physics/stepping.h"
#include "physics/steps.h"

namespace physics {

using geometry::dot;

void hand_over(Scene const& scene, World& world, History& history) {
    history.events.push_back(
        {world.time, EventKind::handover, 0, at(world.legs[0], world.time), world.legs[0].contact, -1});
    world.handed_over = true;
    world.quiet_until = -never;
    world.handover_time = world.time;
    begin_stepping(world);
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        State const state = at(world.legs[i], world.time);
        Leg leg = world.legs[i];
        leg.since = world.time;
        leg.until = never;
        leg.motion = Straight{state, state.velocity, state.spin};
        history.legs[i].back().until = world.time;
        if (history.legs[i].back().since >= world.time) history.legs[i].pop_back();
        history.legs[i].push_back(leg);
        world.legs[i] = leg;
    }
}

void step_handed_over(Scene const& scene, World& world, History& history) {
    double const next = std::nextafter(world.time, never);
    advance_with(Steps{handover_rate}, scene, world, next, history);
}

namespace {

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

}  // namespace

Retaken taken_back(Scene const& scene, World const& world) {
    Retaken retaken;
    for (int i = 0; i < static_cast<int>(scene.balls.size()); ++i) {
        State const state = at(world.legs[i], world.time);
        Contact contact = world.legs[i].contact;
        if (contact.feature >= 0 && !fits(scene.terrain, contact, scene.balls[i].radius)) contact = no_contact;
        retaken.states.push_back(contact.feature >= 0 ? on_track(scene, world, i, state, contact) : state);
        retaken.contacts.push_back(contact);
    }
    return retaken;
}

namespace {

bool balls_are_apart(Scene const& scene, World const& world) {
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        for (std::size_t j = i + 1; j < scene.balls.size(); ++j) {
            Ball const& a = scene.balls[i];
            Ball const& b = scene.balls[j];
            Vec2 const way = at(world.legs[j], world.time).position - at(world.legs[i], world.time).position;
            double const gap = geometry::length(way) - a.radius - b.radius;
            if (gap < takeover_gap * std::min(a.radius, b.radius)) return false;
        }
    }
    return true;
}

// Put on its one surface, a ball must not reach into another: between two it is left to the steps.
bool is_clear(Terrain const& terrain, Vec2 const& centre, double radius) {
    bool clear = true;
    Vec2 const reach = Vec2::Constant(radius);
    terrain.tree.each_overlapping({centre - reach, centre + reach}, [&](int piece) {
        clear = clear && nearest_point(terrain.pieces[piece].curve, centre).distance >= radius - touch_reach;
    });
    return clear;
}

}  // namespace

bool is_apart(Scene const& scene, World const& world) {
    if (world.time - world.handover_time < shortest_handover || !balls_are_apart(scene, world)) return false;
    Retaken const retaken = taken_back(scene, world);
    for (std::size_t i = 0; i < scene.balls.size(); ++i)
        if (!is_clear(scene.terrain, retaken.states[i].position, scene.balls[i].radius)) return false;
    return true;
}

}  // namespace physics
