#include "physics/steps_travel.h"

#include <algorithm>
#include <cmath>

#include "physics/steps_along.h"

namespace physics {

using geometry::dot;
using geometry::length;

namespace {

constexpr int most_turns = 256;     // impacts, stretches and changes of surface in one go; more is a jam
constexpr double grazing = 1e-9;    // share of the speed: slower closing on a surface just left is rounding
constexpr double gentle = 1e-9;     // m/s, touches below this are no events
constexpr double paths_ahead = 24;  // how many substeps' way ahead the surroundings are looked up
constexpr int most_swings = 16;     // parts into which a stiff spring splits a substep
constexpr double swing_part = 0.5;  // rad, of the spring's phase in one part

bool within(geometry::Box const& box, Vec2 const& p) {
    return p.x() >= box.low.x() && p.x() <= box.high.x() && p.y() >= box.low.y() && p.y() <= box.high.y();
}

// How hard the ball is pressed on the shape if it stays on it, per unit mass; negative where it would come off.
double pressure_on(Shape const& shape, Sight const& sight, Traveller const& traveller) {
    State const& state = traveller.state;
    Vec2 const a = acceleration_in(*traveller.field, state.position, state.velocity);
    double const along = geometry::wedge(state.velocity, sight.normal);
    return -(dot(a, sight.normal) + curvature_at(shape, sight.side, traveller.ball->radius) * along * along);
}

// Whether the ball, on `contact`, meets `shape` only because the two belong to one vertex over which it will pass.
bool joined(Terrain const& terrain, Contact contact, Shape const& shape) {
    if (contact.feature == shape.feature) return true;
    int const piece = terrain.is_vertex(contact.feature) ? shape.feature : contact.feature;
    int const vertex = terrain.is_vertex(contact.feature) ? contact.feature : shape.feature;
    if (terrain.is_vertex(piece) || !terrain.is_vertex(vertex)) return false;
    int const place = vertex - terrain.feature_of_vertex(0);
    return terrain.start_vertex[piece] == place || terrain.end_vertex[piece] == place;
}

// What the acceleration makes of a ball within a substep: slower than this it does not get away from a corner.
double slow_speed(Substep const& substep, Traveller const& traveller) {
    return substep.pace * length(acceleration_in(*traveller.field, traveller.state.position, traveller.state.velocity));
}

// Whether a ball that has just met another surface keeps to the one it was on: it leaves it, or closes upon it, so
// slowly that the two together decide what becomes of it.
bool stays_on(Substep const& substep, Traveller const& traveller, Contact contact) {
    if (contact.feature < 0) return false;
    Shape const shape = shape_of(substep.terrain, contact.feature);
    Sight const sight = sight_of(substep.terrain, shape, traveller.state.position);
    double const graze = grazing * length(traveller.state.velocity);
    if (pressure_on(shape, sight, traveller) <= 0) return false;
    return std::abs(dot(traveller.state.velocity, sight.normal)) <= graze + slow_speed(substep, traveller);
}

void glide_over_joint(Substep const& substep, Traveller& traveller, Shape const& shape, double now) {
    Sight const sight = sight_of(substep.terrain, shape, traveller.state.position);
    Vec2 const tangent = geometry::turned_right(sight.normal);
    double const speed = length(traveller.state.velocity);
    traveller.state.velocity = (dot(traveller.state.velocity, tangent) < 0 ? -speed : speed) * tangent;
    seat(substep.terrain, shape, traveller);
    change_contact(substep, traveller, EventKind::joint, {shape.feature, sight.side}, now);
}

}  // namespace

double part_of(Substep const& substep, Traveller const& traveller, double left) {
    if (!traveller.field->pulled) return left;
    double const part = swing_part / std::sqrt(traveller.field->spring.stiffness);
    return std::min({left, substep.pace, std::max(part, substep.pace / most_swings)});
}

double closing_speed(Terrain const& terrain, Shape const& shape, Traveller const& traveller) {
    return -dot(traveller.state.velocity, sight_of(terrain, shape, traveller.state.position).normal);
}

std::vector<Shape> const& shapes_on_the_way(Terrain const& terrain, Traveller& traveller, Vec2 const& to) {
    Surroundings& near = traveller.near;
    if (!within(near.box, traveller.state.position) || !within(near.box, to)) {
        double const reach = traveller.ball->radius + paths_ahead * length(to - traveller.state.position);
        look_around(terrain, traveller.state.position, traveller.ball->radius, reach, near);
    }
    return near.shapes;
}

void change_contact(Substep const& substep, Traveller& traveller, EventKind kind, Contact contact, double now) {
    Contact const touched = kind == EventKind::lift ? traveller.contact : contact;
    traveller.contact = contact;
    substep.events.push_back({substep.since + now, kind, traveller.index, traveller.state, touched, -1});
}

void seat(Terrain const& terrain, Shape const& shape, Traveller& traveller) {
    Sight const sight = sight_of(terrain, shape, traveller.state.position);
    traveller.state.position += (traveller.ball->radius - sight.distance) * sight.normal;
}

void arrive(Substep const& substep, Traveller& traveller, Shape const& shape, double now) {
    Terrain const& terrain = substep.terrain;
    Contact const before = traveller.contact;
    if (before.feature >= 0 && meet_smoothly(terrain, before.feature, shape.feature))
        return glide_over_joint(substep, traveller, shape, now);
    seat(terrain, shape, traveller);
    Sight const sight = sight_of(terrain, shape, traveller.state.position);
    double const closing = -dot(traveller.state.velocity, sight.normal);
    double const pressure = std::max(0.0, pressure_on(shape, sight, traveller));
    // A bounce that would be over within two substeps is none: the ball stays.
    double const slow = before.feature >= 0 ? slow_speed(substep, traveller) : pressure * substep.pace;
    bool const bounces = shape.material->restitution * closing > slow + gentle;
    traveller.state = after_impact(traveller.state, *traveller.ball, sight.normal,
                                   bounces ? shape.material->restitution : 0, shape.material->friction)
                          .state;
    Contact const here{shape.feature, sight.side};
    if (bounces) {
        bool const stays = stays_on(substep, traveller, before);
        if (before.feature >= 0 && !stays) change_contact(substep, traveller, EventKind::lift, no_contact, now);
        substep.events.push_back({substep.since + now, EventKind::bounce, traveller.index, traveller.state, here, -1});
        return;
    }
    if (stays_on(substep, traveller, before)) {
        // Against a second surface while it keeps to the first.
        if (closing > slow + gentle)
            substep.events.push_back(
                {substep.since + now, EventKind::land, traveller.index, traveller.state, here, -1});
        return;
    }
    if (shape.material->restitution == 0) return change_contact(substep, traveller, EventKind::land, here, now);
    // The end of a bounce sequence is told by what follows; rest is told when it has lasted.
    double const across = geometry::wedge(traveller.state.velocity, sight.normal);
    double const rim = -traveller.ball->radius * traveller.state.spin;
    traveller.contact = here;
    if (across == 0 && rim == 0) return;
    change_contact(substep, traveller, slips({0, across, rim, 0}) ? EventKind::slip : EventKind::grip, here, now);
}

Meeting first_meeting(Substep const& substep, Traveller& traveller, Path const& path) {
    Meeting first;
    double const graze = grazing * length(path.velocity);
    bool const riding = traveller.contact.feature >= 0;
    for (Shape const& shape : shapes_on_the_way(substep.terrain, traveller, path.at(path.time))) {
        if (riding && joined(substep.terrain, traveller.contact, shape)) continue;
        double const t = closing_time(substep.terrain, shape, path, traveller.ball->radius);
        if (t >= first.time) continue;
        // Neighbours that the ball glides to without closing on them, and what has just let go, are not run into.
        bool const left_or_next = riding ? meet_smoothly(substep.terrain, traveller.contact.feature, shape.feature)
                                         : t == 0 && traveller.let_go;
        double const slow = riding ? joint_turn * length(path.velocity) : graze;
        if (left_or_next && closing_speed(substep.terrain, shape, traveller) <= slow) continue;
        first = {t, &shape};
    }
    return first;
}

double fly(Substep const& substep, Traveller& traveller, double left) {
    double const time = part_of(substep, traveller, left);
    State& state = traveller.state;
    Flight const end = flight_in(*traveller.field, state.position, state.velocity, time);
    Meeting const met =
        first_meeting(substep, traveller, path_between(state.position, state.velocity, end.position, time));
    traveller.let_go = traveller.still = false;
    traveller.impulse = {};
    double const used = std::min(met.time, time);
    Flight const there = met.shape ? flight_in(*traveller.field, state.position, state.velocity, used) : end;
    state.position = there.position;
    state.velocity = there.velocity;
    state.angle += used * state.spin;
    if (met.shape != nullptr) arrive(substep, traveller, *met.shape, substep.length - left + used);
    return used;
}

Phase phase_of(Traveller const& traveller) {
    if (traveller.still) return Phase::rest;
    if (traveller.contact.feature < 0) return Phase::flight;
    for (Shape const& shape : traveller.near.shapes) {
        if (shape.feature != traveller.contact.feature) continue;
        Vec2 const d = traveller.state.position - shape.origin;
        Vec2 const normal =
            shape.kind == Shape::Kind::line
                ? Vec2(traveller.contact.side * geometry::turned_left(shape.along))
                : Vec2(d * ((curvature_at(shape, traveller.contact.side, traveller.ball->radius) < 0 ? -1 : 1) /
                            length(d)));
        double const across = geometry::wedge(traveller.state.velocity, normal);
        return slips({0, across, -traveller.ball->radius * traveller.state.spin, 0}) ? Phase::slide : Phase::roll;
    }
    return Phase::slide;
}

void travel(Substep const& substep, Traveller& traveller, double since) {
    double left = substep.length - since;
    for (int i = 0; i < most_turns && left > 0; ++i)
        left -= traveller.contact.feature < 0 ? fly(substep, traveller, left) : ride(substep, traveller, left);
    if (left <= 0) return settle_between(substep, traveller);
    // So many impacts in so short a time are a ball jammed in a gap: it stops where it is.
    traveller.state.velocity = Vec2::Zero();
    traveller.state.spin = 0;
}

}  // namespace physics
