#include "physics/steps/stepping.h"

#include <algorithm>
#include <cmath>

#include "physics/steps/proximity.h"
#include "physics/contact/first_contact.h"

namespace physics {

namespace {

// m and m/s: a swing that has died down to this is over. Denormal numbers, which it would come to, slow each step down.
constexpr double over = 1e-200;

geometry::Swing unless_over(geometry::Swing const& swing) {
    return std::max(std::abs(swing.displacement), std::abs(swing.rate)) > over ? swing : geometry::Swing{};
}

}  // namespace

Flight flight_in(Field const& field, Vec2 const& position, Vec2 const& velocity, double time) {
    if (!field.pulled)
        return {position + time * velocity + (0.5 * time * time) * field.gravity, velocity + time * field.gravity};
    geometry::Basis const basis = geometry::basis_at(field.spring, time);
    Vec2 const equilibrium = field.target + field.gravity / field.spring.stiffness;
    Vec2 const d = position - equilibrium;
    geometry::Swing const x = unless_over(swing_after(field.spring, basis, {d.x(), velocity.x()}));
    geometry::Swing const y = unless_over(swing_after(field.spring, basis, {d.y(), velocity.y()}));
    return {equilibrium + Vec2(x.displacement, y.displacement), Vec2(x.rate, y.rate)};
}

void begin_stepping(World& world) {
    world.step_origin = world.time;
    world.steps_taken = 0;
    world.cached_contacts.clear();
    world.ball_pairs.clear();
    world.swells.clear();
    world.fat_boxes.clear();
    world.still_steps.clear();
    world.in_step.clear();
    world.step_forces = world.forces;
    world.clear_until = -never;
}

bool slips(double along, double rim) { return std::abs(along - rim) > no_slip * (std::abs(along) + std::abs(rim)); }

Standing standing_at_start(Scene const& scene, Ball const& ball) {
    State const& state = ball.start;
    Standing standing{state, Phase::flight, {}};
    Surroundings near;
    look_around(scene.terrain, state.position, ball.radius, touch_reach, near);
    double hardest = 0;
    for (Shape const& shape : near.shapes) {
        Proximity const proximity = proximity_of(scene.terrain, shape, state.position);
        double const leaving = geometry::dot(state.velocity, proximity.normal);
        bool const touches = std::abs(proximity.distance - ball.radius) <= touch_reach;
        if (!proximity.faces || !touches || std::abs(leaving) > no_slip * geometry::length(state.velocity)) continue;
        double const along = geometry::cross(state.velocity, proximity.normal);
        double const bend = curvature_at(shape, proximity.side, ball.radius);
        double const pressure = scene.gravity * proximity.normal.y() - bend * along * along;
        if (pressure <= hardest) continue;
        hardest = pressure;
        standing.contact = {shape.feature, proximity.side};
        standing.phase = slips(along, -ball.radius * state.spin) ? Phase::slide : Phase::roll;
    }
    return standing;
}

void open_leg(World& world, History& history, int ball, double now) {
    Leg& leg = world.legs[ball];
    if (leg.since >= now && std::holds_alternative<Straight>(leg.motion)) return;
    State const state = at(leg, now);
    history.legs[ball].back().until = now;
    leg = {now, never, leg.phase, leg.contact, Straight{state, state.velocity, state.spin}};
    history.legs[ball].push_back(leg);
}

void write_leg(World& world, History& history, int ball, double then, Standing const& next) {
    Leg& leg = world.legs[ball];
    Leg& closed = history.legs[ball].back();
    Straight& chord = std::get<Straight>(closed.motion);
    double const span = then - closed.since;
    closed.until = then;
    chord.rate = (next.state.position - chord.from.position) / span;
    chord.angle_rate = (next.state.angle - chord.from.angle) / span;
    leg = {then, never, next.phase, next.contact, Straight{next.state, next.state.velocity, next.state.spin}};
    history.legs[ball].push_back(leg);
}

namespace {

EventKind kind_of_change(Terrain const& terrain, Contact const& before, Contact const& after) {
    if (after.feature < 0) return EventKind::lift;
    if (before.feature < 0) return EventKind::land;
    if (terrain.is_vertex(after.feature)) return EventKind::corner;
    if (terrain.is_vertex(before.feature) || meet_smoothly(terrain, before.feature, after.feature))
        return EventKind::joint;
    return EventKind::land;
}

void tell(EventKind kind, Leg const& after, Contact const& contact, int ball, History& history) {
    history.events.push_back({after.since, kind, ball, std::get<Straight>(after.motion).from, contact, -1});
}

}  // namespace

void tell_contact_change(Terrain const& terrain, Leg const& before, Leg const& after, int ball, History& history) {
    if (before.contact == after.contact) return;
    EventKind const kind = kind_of_change(terrain, before.contact, after.contact);
    tell(kind, after, kind == EventKind::lift ? before.contact : after.contact, ball, history);
}

void tell_phase_change(Leg const& before, Leg const& after, int ball, History& history) {
    if (before.phase == after.phase) return;
    if (after.phase == Phase::rest) tell(EventKind::rest, after, after.contact, ball, history);
    if (before.phase == Phase::slide && after.phase == Phase::roll)
        tell(EventKind::grip, after, after.contact, ball, history);
    if (after.phase == Phase::slide && (before.phase == Phase::roll || before.phase == Phase::rest))
        tell(EventKind::slip, after, after.contact, ball, history);
}

void sort_events(History& history, std::size_t first) {
    std::stable_sort(history.events.begin() + static_cast<std::ptrdiff_t>(first), history.events.end(),
                     [](Event const& a, Event const& b) { return a.time < b.time; });
}

}  // namespace physics
