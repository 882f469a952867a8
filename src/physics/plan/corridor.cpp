#include "physics/plan/corridor.h"

#include <algorithm>
#include <cmath>

#include "geometry/polynomial.h"
#include "physics/plan/leg_plan.h"
#include "physics/motion/impact.h"

namespace physics {

using geometry::Box;
using geometry::cross;
using geometry::dot;
using geometry::Segment;

namespace {

// Ground higher than this above the line of the corridor is in the way, and lower than minus this is not part of it.
constexpr double flat = 1e-12;  // m
// What is farther from the ball than this is not touched, rounding of the corridor's directions included. m
constexpr double clear = 3 * touch_reach;
// Speeds below this share of all are rounding.
constexpr double corridor_rounding = 1e-12;
// Joints that turn by less than this are none: a corridor has one normal. rad
constexpr double straight = 1e-15;
// A ball that comes down nearer than this to the end of a piece may touch something else as well. Radii.
constexpr double end_margin = 1.0 / 16;
// How far a hop's corridor goes beyond the hop, less where something is near, and how far ahead that of a rolling ball
// is looked for. Radii.
struct HopRoom {
    double beside, above;
};
constexpr HopRoom hop_rooms[] = {{0x1p-2, 0x1p-2}, {0x1p-2, 0x1p-14}, {0x1p-8, 0x1p-14}};
constexpr double roll_rooms[] = {32, 8, 2};

// Where a piece lies, seen from a corridor: along it, and above the line of the ground.
struct Extent {
    double left = never, right = -never;
    double low = never, high = -never;
};

Extent extent_of(geometry::Curve const& curve, Corridor const& corridor, double radius) {
    Extent extent;
    Vec2 const normal = geometry::turned_left(corridor.track.along);
    auto const include = [&](Vec2 const& point) {
        Vec2 const from_origin = point - corridor.track.origin;
        double const s = dot(from_origin, corridor.track.along), height = dot(from_origin, normal) + radius;
        extent = {std::min(extent.left, s), std::max(extent.right, s), std::min(extent.low, height),
                  std::max(extent.high, height)};
    };
    if (auto const* segment = std::get_if<Segment>(&curve)) {
        include(segment->start);
        include(segment->end);
        return extent;
    }
    Box const box = geometry::box_of(curve);
    for (Vec2 const& corner : {box.low, box.high, Vec2(box.low.x(), box.high.y()), Vec2(box.high.x(), box.low.y())})
        include(corner);
    return extent;
}

// Whether a ball in the corridor cannot touch anything that is not part of its straight ground.
bool is_free(Terrain const& terrain, Corridor const& corridor, double radius) {
    Box room;
    Vec2 const normal = geometry::turned_left(corridor.track.along);
    Vec2 const middle =
        corridor.track.origin + (corridor.low + corridor.high) / 2 * corridor.track.along + corridor.top / 2 * normal;
    double const around = std::hypot(corridor.high - corridor.low, corridor.top) / 2;
    for (double const s : {corridor.low, corridor.high})
        for (double const height : {0.0, corridor.top}) {
            Vec2 const corner = corridor.track.origin + s * corridor.track.along + height * normal;
            room = united(room, {corner, corner});
        }
    bool free = true;
    terrain.tree.each_overlapping(grown(room, radius + touch_reach), [&](int piece) {
        if (!free || piece == corridor.contact.feature) return;
        geometry::Curve const& curve = terrain.pieces[piece].curve;
        if (nearest_point(curve, middle).distance > radius + around + clear) return;
        Extent const extent = extent_of(curve, corridor, radius);
        bool const is_ground = extent.low >= -flat;
        bool const is_below = extent.high <= -clear;
        bool const is_above = extent.low >= 2 * radius + corridor.top + clear;
        bool const is_beside =
            extent.right < corridor.low - end_margin * radius || extent.left > corridor.high + end_margin * radius;
        free = is_above || (extent.high <= flat && (is_ground || is_below || is_beside || corridor.top == 0));
    });
    return free;
}

// What a flight covers along the corridor, and its height.
struct Span {
    double low = 0, high = 0;
    double top = 0;
};
Span span_of(Corridor const& corridor, State const& from, Vec2 const& acceleration, double duration) {
    double const s = dot(from.position - corridor.track.origin, corridor.track.along);
    double const drift = dot(acceleration, corridor.track.along);
    double const end = s + duration * (dot(from.velocity, corridor.track.along) + 0.5 * duration * drift);
    // A parabola strays from its chord by an eighth of its acceleration times the square of the time.
    double const stray = std::abs(drift) * duration * duration / 8;
    double const height = dot(from.velocity, geometry::turned_left(corridor.track.along)) * duration / 4;
    return {std::min(s, end) - stray, std::max(s, end) + stray, height};
}

bool holds(Corridor const& corridor, Span const& span) {
    return span.low >= corridor.low && span.high <= corridor.high && span.top <= corridor.top;
}

bool is_segment(Terrain const& terrain, Contact contact) {
    return contact.feature >= 0 && !terrain.is_vertex(contact.feature) &&
           std::holds_alternative<Segment>(terrain.pieces[contact.feature].curve);
}

}  // namespace

Corridor corridor_of_hop(Terrain const& terrain, Ball const& ball, Contact contact, Ballistic const& flight,
                         double duration) {
    if (!is_segment(terrain, contact)) return {};
    Corridor corridor;
    corridor.contact = contact;
    corridor.track = track_of(terrain, contact, ball.radius);
    double const margin = end_margin * ball.radius;
    corridor.low = margin;
    corridor.high = corridor.track.length - margin;
    corridor.top = never;
    Span const span = span_of(corridor, flight.from, flight.acceleration, duration);
    if (!holds(corridor, span)) return {};
    double const low = corridor.low, high = corridor.high;
    for (HopRoom const& room : hop_rooms) {
        double const beside = (span.high - span.low) + room.beside * ball.radius;
        corridor.low = std::max(low, span.low - beside);
        corridor.high = std::min(high, span.high + beside);
        corridor.top = span.top + room.above * ball.radius;
        if (is_free(terrain, corridor, ball.radius)) return corridor;
    }
    return {};
}

std::optional<Hop> next_hop(Corridor const& corridor, Terrain const& terrain, Ball const& ball, Ballistic const& flight,
                            double duration) {
    State state = state_on(flight, duration);
    Vec2 const normal = geometry::turned_left(corridor.track.along);
    Material const& material = terrain.pieces[corridor.contact.feature].material;
    ContactSpeeds const before{dot(state.velocity, normal), dot(state.velocity, corridor.track.along),
                               -ball.radius * state.spin};
    ContactSpeeds const after = after_impact(before, material.restitution, material.friction, ball.inertia);
    double const pressing = -dot(flight.acceleration, normal);
    double const rounding =
        corridor_rounding * (std::abs(before.normal) + std::abs(before.tangent) + std::abs(before.rim));
    if (!(before.normal < -rounding && after.normal > rounding)) return std::nullopt;
    if (!(after.normal * after.normal >= 2 * pressing * lowest_hop_of_sums * ball.radius)) return std::nullopt;
    state.velocity = after.normal * normal + after.tangent * corridor.track.along;
    state.spin = -after.rim / ball.radius;
    Hop const hop{state, 2 * after.normal / pressing};
    if (!holds(corridor, span_of(corridor, state, flight.acceleration, hop.duration))) return std::nullopt;
    return hop;
}

namespace {

// Where the track of `contact` ends in the direction in which the ball rolls.
std::optional<Junction> junction_at(Terrain const& terrain, Corridor const& corridor, Contact contact) {
    bool const at_start = (contact.side > 0) == (corridor.direction < 0);
    int const index = at_start ? terrain.start_vertex[contact.feature] : terrain.end_vertex[contact.feature];
    std::vector<IncidentEdge> const& edges = terrain.vertices[index].edges;
    if (edges.size() != 2) return std::nullopt;
    bool const first_is_mine = edges[0].piece == contact.feature && edges[0].at_start == at_start;
    IncidentEdge const& mine = edges[first_is_mine ? 0 : 1];
    IncidentEdge const& other = edges[first_is_mine ? 1 : 0];
    bool const opposite =
        std::abs(cross(mine.direction, other.direction)) <= straight && dot(mine.direction, other.direction) < 0;
    auto const* segment = std::get_if<Segment>(&terrain.pieces[other.piece].curve);
    Material const& here = terrain.pieces[contact.feature].material;
    Material const& there = terrain.pieces[other.piece].material;
    if (!opposite || segment == nullptr || there.friction != here.friction) return std::nullopt;
    if (here.rolling_resistance != 0 || there.rolling_resistance != 0) return std::nullopt;
    int const side = other.at_start == at_start ? -contact.side : contact.side;
    return Junction{{other.piece, side}, std::abs(dot(segment->end - segment->start, corridor.track.along))};
}

// The ball's centre at the beginning or, rolling backwards, at the end of the track of a piece.
Vec2 entry_of(Terrain const& terrain, Corridor const& corridor, Contact contact, double radius) {
    auto const& segment = std::get<Segment>(terrain.pieces[contact.feature].curve);
    Vec2 const& corner = (contact.side > 0) == (corridor.direction > 0) ? segment.start : segment.end;
    return corner + radius * geometry::turned_left(corridor.track.along);
}

}  // namespace

Corridor corridor_of_roll(Terrain const& terrain, Ball const& ball, Contact contact, double q, Ballistic const& roll) {
    if (!is_segment(terrain, contact)) return {};
    Corridor corridor;
    corridor.contact = contact;
    corridor.track = track_of(terrain, contact, ball.radius);
    corridor.direction = dot(roll.from.velocity, corridor.track.along) > 0 ? 1 : -1;
    auto const ahead = junction_at(terrain, corridor, contact);
    if (!ahead) return {};
    corridor.here = {contact, 0, corridor.track.length, *ahead};
    for (double const room : roll_rooms) {
        double const end = q + corridor.direction * room * ball.radius;
        corridor.low = std::min(q, end);
        corridor.high = std::max(q, end);
        if (is_free(terrain, corridor, ball.radius)) return corridor;
    }
    return {};
}

std::optional<Crossing> next_crossing(Corridor const& corridor, Terrain const& terrain, Ball const& ball,
                                      Ballistic const& roll, double duration) {
    Section const& here = corridor.here;
    bool const forwards = corridor.direction > 0;
    double const length = here.ahead.length;
    double const begin = forwards ? here.begin + here.length : here.begin - length;
    if (begin < corridor.low || begin + length > corridor.high) return std::nullopt;
    auto const ahead = junction_at(terrain, corridor, here.ahead.next);
    if (!ahead) return std::nullopt;

    State const before = state_on(roll, duration);
    Vec2 const& along = corridor.track.along;
    double const speed = dot(before.velocity, along);
    double const pace = corridor.direction * speed, gain = corridor.direction * dot(roll.acceleration, along);
    if (!(pace > 0)) return std::nullopt;
    auto const forth = geometry::first_quadratic_fall(length, -pace, -gain / 2, never);
    auto const again = geometry::first_quadratic_fall(0, pace, gain / 2, never);
    if (!forth && !again) return std::nullopt;
    bool const returns = !forth || (again && *again < *forth);

    TrackEnd const back{EndKind::joint, forwards ? 0 : length, here.contact, forwards ? here.length : 0};
    TrackEnd const on{EndKind::joint, forwards ? length : 0, ahead->next, forwards ? 0 : ahead->length};
    return Crossing{
        {here.ahead.next, begin, length, *ahead},
        {entry_of(terrain, corridor, here.ahead.next, ball.radius), speed * along, before.angle, -speed / ball.radius},
        forwards ? TrackEnds{back, on} : TrackEnds{on, back},
        returns ? -corridor.direction : corridor.direction,
        returns ? *again : *forth};
}

}  // namespace physics
