#include "physics/clearing.h"

#include <algorithm>
#include <cmath>

#include "geometry/polynomial.h"
#include "physics/course.h"
#include "physics/impact.h"

namespace physics {

using geometry::Box;
using geometry::dot;
using geometry::Segment;
using geometry::wedge;

namespace {

// Ground higher than this above the line of the clearing is in the way, and lower than minus this is not part of it.
constexpr double flat = 1e-12;  // m
// Speeds below this share of all are rounding.
constexpr double clearing_rounding = 1e-12;
// Joints that turn by less than this are none: a clearing has one normal. rad
constexpr double straight = 1e-15;
// A ball that comes down nearer than this to the end of a piece may touch something else as well. Radii.
constexpr double end_margin = 1.0 / 16;
// How far a hop's clearing goes beyond the hop, and how far ahead that of a rolling ball is looked for. Radii.
constexpr double hop_room = 1.0 / 4;
constexpr double roll_rooms[] = {32, 8, 2};

// Where a piece lies, seen from a clearing: along it, and above the line of the ground.
struct Extent {
    double left = never, right = -never;
    double low = never, high = -never;
};

Extent extent_of(geometry::Curve const& curve, Clearing const& clearing, double radius) {
    Extent extent;
    Vec2 const normal = geometry::turned_left(clearing.track.along);
    auto const include = [&](Vec2 const& point) {
        Vec2 const from_origin = point - clearing.track.origin;
        double const s = dot(from_origin, clearing.track.along), height = dot(from_origin, normal) + radius;
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

// Whether a ball in the clearing cannot touch anything that is not part of its straight ground.
bool is_free(Terrain const& terrain, Clearing const& clearing, double radius) {
    Box room;
    Vec2 const normal = geometry::turned_left(clearing.track.along);
    for (double const s : {clearing.low, clearing.high})
        for (double const height : {0.0, clearing.top}) {
            Vec2 const corner = clearing.track.origin + s * clearing.track.along + height * normal;
            room = united(room, {corner, corner});
        }
    bool free = true;
    terrain.tree.each_overlapping(grown(room, radius + touch_reach), [&](int piece) {
        if (!free || piece == clearing.contact.feature) return;
        Extent const extent = extent_of(terrain.pieces[piece].curve, clearing, radius);
        bool const is_ground = extent.low >= -flat;
        bool const is_below = extent.high <= -3 * touch_reach;
        bool const is_beside =
            extent.right < clearing.low - end_margin * radius || extent.left > clearing.high + end_margin * radius;
        free = extent.high <= flat && (is_ground || is_below || is_beside || clearing.top == 0);
    });
    return free;
}

// What a flight covers along the clearing, and its height.
struct Span {
    double low = 0, high = 0;
    double top = 0;
};
Span span_of(Clearing const& clearing, State const& from, Vec2 const& acceleration, double duration) {
    double const s = dot(from.position - clearing.track.origin, clearing.track.along);
    double const drift = dot(acceleration, clearing.track.along);
    double const end = s + duration * (dot(from.velocity, clearing.track.along) + 0.5 * duration * drift);
    // A parabola strays from its chord by an eighth of its acceleration times the square of the time.
    double const stray = std::abs(drift) * duration * duration / 8;
    double const height = dot(from.velocity, geometry::turned_left(clearing.track.along)) * duration / 4;
    return {std::min(s, end) - stray, std::max(s, end) + stray, height};
}

bool holds(Clearing const& clearing, Span const& span) {
    return span.low >= clearing.low && span.high <= clearing.high && span.top <= clearing.top;
}

bool is_segment(Terrain const& terrain, Contact contact) {
    return contact.feature >= 0 && !terrain.is_vertex(contact.feature) &&
           std::holds_alternative<Segment>(terrain.pieces[contact.feature].curve);
}

}  // namespace

Clearing clearing_of_hop(Terrain const& terrain, Ball const& ball, Contact contact, Ballistic const& flight,
                         double duration) {
    if (!is_segment(terrain, contact)) return {};
    Clearing clearing;
    clearing.contact = contact;
    clearing.track = track_of(terrain, contact, ball.radius);
    double const margin = end_margin * ball.radius;
    clearing.low = margin;
    clearing.high = clearing.track.length - margin;
    clearing.top = never;
    Span const span = span_of(clearing, flight.from, flight.acceleration, duration);
    if (!holds(clearing, span)) return {};
    double const room = (span.high - span.low) + hop_room * ball.radius;
    clearing.low = std::max(clearing.low, span.low - room);
    clearing.high = std::min(clearing.high, span.high + room);
    clearing.top = span.top + hop_room * ball.radius;
    return is_free(terrain, clearing, ball.radius) ? clearing : Clearing{};
}

std::optional<Hop> next_hop(Clearing const& clearing, Terrain const& terrain, Ball const& ball, Ballistic const& flight,
                            double duration) {
    State state = state_on(flight, duration);
    Vec2 const normal = geometry::turned_left(clearing.track.along);
    Material const& material = terrain.pieces[clearing.contact.feature].material;
    ContactSpeeds const before{dot(state.velocity, normal), dot(state.velocity, clearing.track.along),
                               -ball.radius * state.spin};
    ContactSpeeds const after = after_impact(before, material.restitution, material.friction, ball.inertia);
    double const pressing = -dot(flight.acceleration, normal);
    double const rounding =
        clearing_rounding * (std::abs(before.normal) + std::abs(before.tangent) + std::abs(before.rim));
    if (!(before.normal < -rounding && after.normal > rounding)) return std::nullopt;
    if (!(after.normal * after.normal >= 2 * pressing * lowest_hop_of_sums * ball.radius)) return std::nullopt;
    state.velocity = after.normal * normal + after.tangent * clearing.track.along;
    state.spin = -after.rim / ball.radius;
    Hop const hop{state, 2 * after.normal / pressing};
    if (!holds(clearing, span_of(clearing, state, flight.acceleration, hop.duration))) return std::nullopt;
    return hop;
}

namespace {

// Where the track of `contact` ends in the direction in which the ball rolls.
std::optional<Junction> junction_at(Terrain const& terrain, Clearing const& clearing, Contact contact) {
    bool const at_start = (contact.side > 0) == (clearing.direction < 0);
    int const index = at_start ? terrain.start_vertex[contact.feature] : terrain.end_vertex[contact.feature];
    std::vector<Spoke> const& spokes = terrain.vertices[index].spokes;
    if (spokes.size() != 2) return std::nullopt;
    bool const first_is_mine = spokes[0].piece == contact.feature && spokes[0].at_start == at_start;
    Spoke const& mine = spokes[first_is_mine ? 0 : 1];
    Spoke const& other = spokes[first_is_mine ? 1 : 0];
    bool const opposite =
        std::abs(wedge(mine.direction, other.direction)) <= straight && dot(mine.direction, other.direction) < 0;
    auto const* segment = std::get_if<Segment>(&terrain.pieces[other.piece].curve);
    Material const& here = terrain.pieces[contact.feature].material;
    Material const& there = terrain.pieces[other.piece].material;
    if (!opposite || segment == nullptr || there.friction != here.friction) return std::nullopt;
    if (here.rolling_resistance != 0 || there.rolling_resistance != 0) return std::nullopt;
    int const side = other.at_start == at_start ? -contact.side : contact.side;
    return Junction{{other.piece, side}, std::abs(dot(segment->end - segment->start, clearing.track.along))};
}

// The ball's centre at the beginning or, rolling backwards, at the end of the track of a piece.
Vec2 entry_of(Terrain const& terrain, Clearing const& clearing, Contact contact, double radius) {
    auto const& segment = std::get<Segment>(terrain.pieces[contact.feature].curve);
    Vec2 const& corner = (contact.side > 0) == (clearing.direction > 0) ? segment.start : segment.end;
    return corner + radius * geometry::turned_left(clearing.track.along);
}

}  // namespace

Clearing clearing_of_roll(Terrain const& terrain, Ball const& ball, Contact contact, double q, Ballistic const& roll) {
    if (!is_segment(terrain, contact)) return {};
    Clearing clearing;
    clearing.contact = contact;
    clearing.track = track_of(terrain, contact, ball.radius);
    clearing.direction = dot(roll.from.velocity, clearing.track.along) > 0 ? 1 : -1;
    auto const ahead = junction_at(terrain, clearing, contact);
    if (!ahead) return {};
    clearing.here = {contact, 0, clearing.track.length, *ahead};
    for (double const room : roll_rooms) {
        double const end = q + clearing.direction * room * ball.radius;
        clearing.low = std::min(q, end);
        clearing.high = std::max(q, end);
        if (is_free(terrain, clearing, ball.radius)) return clearing;
    }
    return {};
}

std::optional<Crossing> next_crossing(Clearing const& clearing, Terrain const& terrain, Ball const& ball,
                                      Ballistic const& roll, double duration) {
    Section const& here = clearing.here;
    bool const forwards = clearing.direction > 0;
    double const length = here.ahead.length;
    double const begin = forwards ? here.begin + here.length : here.begin - length;
    if (begin < clearing.low || begin + length > clearing.high) return std::nullopt;
    auto const ahead = junction_at(terrain, clearing, here.ahead.next);
    if (!ahead) return std::nullopt;

    State const before = state_on(roll, duration);
    Vec2 const& along = clearing.track.along;
    double const speed = dot(before.velocity, along);
    double const pace = clearing.direction * speed, gain = clearing.direction * dot(roll.acceleration, along);
    if (!(pace > 0)) return std::nullopt;
    auto const forth = geometry::first_quadratic_fall(length, -pace, -gain / 2, never);
    auto const again = geometry::first_quadratic_fall(0, pace, gain / 2, never);
    if (!forth && !again) return std::nullopt;
    bool const returns = !forth || (again && *again < *forth);

    TrackEnd const back{EndKind::joint, forwards ? 0 : length, here.contact, forwards ? here.length : 0};
    TrackEnd const on{EndKind::joint, forwards ? length : 0, ahead->next, forwards ? 0 : ahead->length};
    return Crossing{
        {here.ahead.next, begin, length, *ahead},
        {entry_of(terrain, clearing, here.ahead.next, ball.radius), speed * along, before.angle, -speed / ball.radius},
        forwards ? TrackEnds{back, on} : TrackEnds{on, back},
        returns ? -clearing.direction : clearing.direction,
        returns ? *again : *forth};
}

}  // namespace physics
