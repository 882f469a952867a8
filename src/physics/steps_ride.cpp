// Riding: a ball on one surface, moved along it in the surface's own terms, so that it neither sinks nor loses speed.
#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "physics/steps_along.h"
#include "physics/steps_travel.h"

namespace physics {

using geometry::dot;
using geometry::wedge;

namespace {

constexpr double finest_turn = 0.02;   // rad, of the normal in one stretch
constexpr double finest_swing = 0.02;  // rad, of a pendulum's phase in one stretch: its period is right to 2e-5
constexpr double coming_off = 0.5;     // share of the pressure: below, the stretch may outlast the contact
constexpr double small_turn = 0.05;    // rad
constexpr int most_stretches = 16;     // into which a tight bend splits a substep
constexpr double weightless = 1e-12;   // share of the acceleration: less pressure is none
constexpr double ride_standing = 1e-12;     // m/s

// The ball's place on its surface: unit normal from terrain to ball, tangent t = (n.y, -n.x), and how the surface
// bends.
struct Place {
    Vec2 normal = Vec2::Zero();
    Vec2 tangent = Vec2::Zero();
    Vec2 position = Vec2::Zero();
    double curvature = 0;  // 1/m, of the centre's path, positive where the surface bulges
    double rho = 0;        // m, its reciprocal
};

Place place_of(Shape const& shape, Traveller const& traveller) {
    Place place;
    Vec2 const d = traveller.state.position - shape.origin;
    double const radius = traveller.ball->radius;
    place.curvature = curvature_at(shape, traveller.contact.side, radius);
    if (shape.kind == Shape::Kind::line) {
        place.normal = traveller.contact.side * geometry::turned_left(shape.along);
        place.position = shape.origin + dot(d, shape.along) * shape.along + radius * place.normal;
    } else {
        double const sign = place.curvature < 0 ? -1 : 1;
        place.normal = d * (sign / geometry::length(d));
        place.rho = 1 / place.curvature;
        place.position = shape.origin + place.rho * place.normal;
    }
    place.tangent = geometry::turned_right(place.normal);
    return place;
}

// For the small angles of one stretch the first terms of the series are exact to the last bit.
geometry::SineCosine turn_by(double angle) {
    if (std::abs(angle) > small_turn) return geometry::sine_cosine(angle);
    double const x = angle * angle;
    double const sine = angle * (1 - x * (1.0 / 6) * (1 - x * (1.0 / 20) * (1 - x * (1.0 / 42))));
    return {sine, 1 - x * 0.5 * (1 - x * (1.0 / 12) * (1 - x * (1.0 / 30) * (1 - x * (1.0 / 56))))};
}

// Moving `way` along t turns the normal by -curvature * way.
Place place_after(Shape const& shape, Place const& place, double way) {
    Place next = place;
    if (shape.kind == Shape::Kind::line) {
        next.position += way * place.tangent;
        return next;
    }
    auto const [sine, cosine] = turn_by(-place.curvature * way);
    next.normal = geometry::turned(place.normal, cosine, sine);
    next.tangent = geometry::turned_right(next.normal);
    next.position = shape.origin + place.rho * next.normal;
    return next;
}

// What acts at a place but for contact, along and off the surface.
struct Pull {
    double along = 0;  // m/s^2, along t
    double off = 0;    // m/s^2, along n
};
Pull pull_at(Place const& place, Field const& field, double speed) {
    Vec2 const a = acceleration_in(field, place.position, speed * place.tangent);
    return {dot(a, place.tangent), dot(a, place.normal)};
}

double pressure_at(Place const& place, Pull const& pull, double speed) {
    double const pressure = -(pull.off + place.curvature * speed * speed);
    return pressure > weightless * (std::abs(pull.off) + std::abs(pull.along)) ? pressure : 0;
}

// Forces as they are in the middle of the stretch: of second order, and they neither feed nor drain a swing.
Drive drive_over(Shape const& shape, Place const& place, Traveller const& traveller, double speed, double time) {
    Field const& field = *traveller.field;
    Place const middle = place_after(shape, place, 0.5 * speed * time);
    Pull const pull = pull_at(middle, field, speed);
    Drive drive;
    drive.material = *shape.material;
    drive.inertia = traveller.ball->inertia;
    drive.push = dot(field.gravity, middle.tangent);
    drive.pulled = field.pulled;
    if (field.pulled) {
        drive.spring = field.spring;
        drive.offset = dot(middle.position - field.target, middle.tangent) - 0.5 * speed * time;
    }
    drive.pressure = pressure_at(middle, pull, speed + 0.5 * time * pull.along / (1 + drive.inertia));
    return drive;
}

// How far beyond its surface's end a ball at `place` is, in the sense of `way`, and over which vertex.
struct Overrun {
    double way = 0;  // m, positive if it is
    int vertex = -1;
    Spoke const* spoke = nullptr;  // leaving a vertex: where it goes
};

Overrun beyond_line(Terrain const& terrain, Shape const& shape, Contact contact, Place const& place, double way) {
    double const x = dot(place.position - shape.origin, shape.along);
    bool const onward = way * contact.side > 0;
    if (onward) return {x - shape.extent, terrain.end_vertex[shape.feature], nullptr};
    return {-x, terrain.start_vertex[shape.feature], nullptr};
}

Overrun beyond_arc(Terrain const& terrain, Shape const& shape, Place const& place, double way) {
    if (shape.extent == -2) return {};
    Vec2 const outward = place.curvature < 0 ? Vec2(-place.normal) : place.normal;
    bool const counter_clockwise = -place.curvature * way > 0;
    Vec2 const end = counter_clockwise ? shape.last : shape.first;
    if (dot(outward, shape.along) >= dot(end, shape.along)) return {};
    double const turn = geometry::arctangent(wedge(end, outward), dot(end, outward)) * (counter_clockwise ? 1 : -1);
    // Behind the end by less than a quarter turn, not far ahead of it on the other way round.
    if (turn <= 0 || turn >= geometry::pi / 2) return {};
    bool const to_end = counter_clockwise == (shape.turn > 0);
    return {turn * std::abs(place.rho),
            to_end ? terrain.end_vertex[shape.feature] : terrain.start_vertex[shape.feature], nullptr};
}

Overrun beyond_vertex(Terrain const& terrain, Shape const& shape, Place const& place, double way) {
    Overrun overrun;
    for (Spoke const& spoke : terrain.vertex(shape.feature).spokes) {
        double const rise = dot(place.normal, spoke.direction);
        if (rise <= 0 || dot(place.tangent, spoke.direction) * way <= 0) continue;
        double const turn = geometry::arctangent(rise, std::abs(wedge(place.normal, spoke.direction)));
        double const over = turn * std::abs(place.rho);
        if (over > overrun.way) overrun = {over, -1, &spoke};
    }
    return overrun;
}

Overrun beyond(Terrain const& terrain, Shape const& shape, Contact contact, Place const& place, double way) {
    if (way == 0) return {};
    switch (shape.kind) {
        case Shape::Kind::line:
            return beyond_line(terrain, shape, contact, place, way);
        case Shape::Kind::arc:
            return beyond_arc(terrain, shape, place, way);
        case Shape::Kind::vertex:
            return beyond_vertex(terrain, shape, place, way);
    }
    return {};
}

// When a ball that goes `way` in `time`, starting at `speed`, has gone `part` of it.
double time_for(double part, double way, double speed, double time) {
    double const sign = way < 0 ? -1 : 1;
    double const v = speed * sign, a = 2 * (std::abs(way) / time - v) / time;
    double const root = std::sqrt(std::max(0.0, v * v + 2 * a * part));
    double const t = v + root > 0 ? 2 * part / (v + root) : 0;
    return std::clamp(t, 0.0, time);
}

void put(Traveller& traveller, Place const& place, Along const& along) {
    double const radius = traveller.ball->radius;
    traveller.state.position = place.position;
    traveller.state.velocity = along.speed * place.tangent;
    traveller.state.spin = -along.rim / radius;
    traveller.state.angle -= along.rolled / radius;
}

void pass_over_end(Substep const& substep, Traveller& traveller, Overrun const& overrun, Vec2 const& normal,
                   double now) {
    Terrain const& terrain = substep.terrain;
    if (overrun.spoke != nullptr)
        return change_contact(substep, traveller, EventKind::joint, contact_on(*overrun.spoke, normal), now);
    Passage const passage = passage_over(terrain, traveller.contact, overrun.vertex, normal);
    if (terrain.is_vertex(passage.to.feature))
        return change_contact(substep, traveller, EventKind::corner, passage.to, now);
    arrive(substep, traveller, shape_of(terrain, passage.to.feature), now);
}

Shape const* shape_under(Substep const& substep, Traveller& traveller) {
    for (Shape const& shape : shapes_on_the_way(substep.terrain, traveller, traveller.state.position))
        if (shape.feature == traveller.contact.feature) return &shape;
    return nullptr;
}

// A constant push along a line has a closed form for any time. On a bend a stretch is as long as its second order is
// good for: a small turn, and a small part of a swing to and fro. A spring is followed substep by substep.
double stretch_of(Substep const& substep, Traveller const& traveller, Place const& place, double speed, double left) {
    bool const pulled = traveller.field->pulled;
    if (place.curvature == 0 && !pulled) return left;
    double const bend = std::abs(place.curvature);
    double const turn_rate = bend * std::abs(speed);
    double const swing_rate = std::sqrt(bend * geometry::length(traveller.field->gravity));
    double part = left;
    if (part * turn_rate > finest_turn) part = std::max(finest_turn / turn_rate, substep.pace / most_stretches);
    if (part * swing_rate > finest_swing) part = std::max(finest_swing / swing_rate, substep.pace / most_stretches);
    return pulled ? part_of(substep, traveller, part) : part;
}

// One stretch on a surface: as far as it goes, and what ends it.
struct Stretch {
    Place end;
    Along along;
    double time = 0;  // s
    Overrun overrun;
    Meeting met;
};

Stretch stretch_along(Substep const& substep, Traveller& traveller, Shape const& shape, Place const& place,
                      Along const& start, Drive const& drive, double time) {
    Stretch stretch{place, after_moving(drive, start, time), time, {}, {}};
    stretch.end = place_after(shape, place, stretch.along.way);
    double const way = stretch.along.way;
    stretch.overrun = beyond(substep.terrain, shape, traveller.contact, stretch.end, way);
    stretch.met = first_meeting(substep, traveller,
                                path_between(place.position, start.speed * place.tangent, stretch.end.position, time));
    bool const over = stretch.overrun.way > 0;
    double const within = std::max(0.0, std::abs(way) - stretch.overrun.way);
    double const time_to_end = over ? time_for(within, way, start.speed, time) : time;
    bool const meets = stretch.met.shape != nullptr && (!over || stretch.met.time < time_to_end);
    if (!over && !meets) return stretch;
    stretch.time = meets ? stretch.met.time : time_to_end;
    stretch.along = after_moving(drive, start, stretch.time);
    if (meets) stretch.overrun = {};
    if (!meets) {
        stretch.met = {};
        stretch.along.way = std::copysign(within, way);
    }
    stretch.end = place_after(shape, place, stretch.along.way);
    return stretch;
}

// Runs into another surface; true if it stays pressed between the two.
bool runs_into(Substep const& substep, Traveller& traveller, Shape const& other, double now) {
    Contact const before = traveller.contact;
    arrive(substep, traveller, other, now);
    double const leaving = -closing_speed(substep.terrain, other, traveller);
    return traveller.contact == before && leaving <= ride_standing + no_slip * geometry::length(traveller.state.velocity);
}

}  // namespace

double ride(Substep const& substep, Traveller& traveller, double left) {
    double const now = substep.length - left;
    Shape const* found = shape_under(substep, traveller);
    if (found == nullptr) {
        change_contact(substep, traveller, EventKind::lift, no_contact, now);
        return 0;
    }
    Shape const shape = *found;
    Place const place = place_of(shape, traveller);
    Along start;
    start.speed = dot(traveller.state.velocity, place.tangent);
    start.rim = -traveller.ball->radius * traveller.state.spin;
    double time = stretch_of(substep, traveller, place, start.speed, left);
    double const pressure = pressure_at(place, pull_at(place, *traveller.field, start.speed), start.speed);
    if (pressure == 0) {
        traveller.let_go = true;
        change_contact(substep, traveller, EventKind::lift, no_contact, now);
        return 0;
    }
    Drive drive = drive_over(shape, place, traveller, start.speed, time);
    if (time > substep.pace && drive.pressure < coming_off * pressure) {
        time = substep.pace;
        drive = drive_over(shape, place, traveller, start.speed, time);
    }
    // The last stretch before it comes off.
    if (drive.pressure == 0) drive.pressure = 0.5 * pressure;
    traveller.state.position = place.position;
    Stretch const stretch = stretch_along(substep, traveller, shape, place, start, drive, time);
    put(traveller, stretch.end, stretch.along);
    traveller.impulse = {drive.pressure * stretch.time, stretch.along.speed - start.speed - drive.push * stretch.time};
    traveller.still = std::abs(start.speed) <= ride_standing && std::abs(stretch.along.speed) <= ride_standing &&
                      std::abs(stretch.along.rim) <= ride_standing;
    if (stretch.met.shape != nullptr) {
        Shape const other = *stretch.met.shape;
        if (runs_into(substep, traveller, other, now + stretch.time)) {
            double const wedged = std::min(left - stretch.time, substep.pace);
            wedge_between(substep, traveller, shape, other, wedged);
            return stretch.time + wedged;
        }
    } else if (stretch.overrun.way > 0) {
        pass_over_end(substep, traveller, stretch.overrun, stretch.end.normal, now + stretch.time);
    }
    return stretch.time;
}

}  // namespace physics
