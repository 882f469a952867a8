#include "physics/contact/track_ends.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"

namespace physics {

using geometry::pi;

namespace {

constexpr int towards_high = 1;
constexpr int towards_low = -1;

// The end of a piece that its track reaches in a direction: side +1 runs from start to end on straight pieces and on
// those that are passed on the left.
bool ends_at_start(Contact contact, int direction) { return (contact.side > 0) == (direction == towards_low); }

std::size_t edge_of(Vertex const& vertex, int piece, bool at_start) {
    for (std::size_t i = 0; i < vertex.edges.size(); ++i)
        if (vertex.edges[i].piece == piece && vertex.edges[i].at_start == at_start) return i;
    return 0;
}

// The edge that a ball meets next when it goes round the vertex from edge i, and by how much more than a straight
// line the surface has turned away there (rad; negative: it has turned towards the ball).
struct Turn {
    std::size_t edge = 0;
    double away = 0;
};
Turn turn_from(Vertex const& vertex, std::size_t i, bool ball_is_left) {
    std::size_t const count = vertex.edges.size();
    std::size_t const next = ball_is_left ? (i + 1) % count : (i + count - 1) % count;
    if (next == i) return {i, pi};
    double gap = angle_of(vertex.edges[next].direction) - angle_of(vertex.edges[i].direction);
    if (!ball_is_left) gap = -gap;
    if (gap <= 0) gap += 2 * pi;
    return {next, gap - pi};
}

// The contact of a ball that lies clockwise or counter-clockwise of a edge.
Contact beside(IncidentEdge const& edge, bool ball_is_left) {
    return {edge.piece, edge.at_start == ball_is_left ? 1 : -1};
}

// Where the track of `contact` begins or ends at this vertex.
double coordinate_at(Terrain const& terrain, Contact contact, bool at_start, double radius) {
    if (!fits(terrain, contact, radius)) return 0;
    Track const track = track_of(terrain, contact, radius);
    return ends_at_start(contact, towards_low) == at_start ? 0 : track.length;
}

// A ball goes on to the next track a little after it begins, as far on it as it went too far on this one: about where
// two tracks meet it may swing for ever by rounding alone, and no event comes of it.
constexpr double joint_slack = 1e-12;  // m

TrackEnd goes_on_to(EndKind kind, double q, int direction, Contact next, double next_q) {
    return {kind, q + direction * joint_slack, next, next_q + direction * joint_slack};
}

// A joint that turns towards the ball is passed where the two tracks cross: half the turn before the vertex where they
// are straight, and from there by Newton's rule. `early` (m) is how far before the vertex that is; below this the
// rounding of places moves the crossing by as much, and the first guess stands.
constexpr double least_crossing = 2e-6;  // m

double crossing_of(Track const& track, Track const& ahead, double q, double early) {
    double const begin = q;
    if (early < least_crossing) return begin;
    for (int i = 0; i < 3; ++i) {
        Vec2 const place = position_at(track, q);
        double const there = nearest_coordinate(ahead, place);
        Vec2 const normal = normal_at(ahead, there);
        double const slope = geometry::dot(geometry::turned_right(normal_at(track, q)), normal);
        double const step = geometry::dot(place - position_at(ahead, there), normal) / slope;
        if (!(std::abs(q - step - begin) <= early)) return begin;
        q -= step;
    }
    return q;
}

TrackEnd end_of_piece(Terrain const& terrain, Contact contact, Track const& track, double radius, int direction) {
    bool const at_start = ends_at_start(contact, direction);
    int const index = at_start ? terrain.start_vertex[contact.feature] : terrain.end_vertex[contact.feature];
    Vertex const& vertex = terrain.vertices[index];
    std::size_t const edge = edge_of(vertex, contact.feature, at_start);
    bool const left = (contact.side > 0) == at_start;
    Turn const turn = turn_from(vertex, edge, left);
    double const q = direction == towards_high ? track.length : 0;
    if (turn.away >= joint_turn) {
        Contact const pivot{terrain.feature_of_vertex(index), 1};
        Track const round = track_of(terrain, pivot, radius);
        return goes_on_to(EndKind::corner, q, direction, pivot, direction == towards_high ? 0 : round.length);
    }
    IncidentEdge const& neighbour = vertex.edges[turn.edge];
    Contact const next = beside(neighbour, !left);
    if (turn.away <= -joint_turn || !fits(terrain, next, radius)) return {EndKind::wall, q, next, 0};
    double const entry = coordinate_at(terrain, next, neighbour.at_start, radius);
    double const early = std::max(0.0, -turn.away) / 2 * radius;
    if (early <= joint_slack) return goes_on_to(EndKind::joint, q, direction, next, entry);
    Track const ahead = track_of(terrain, next, radius);
    double const cross = crossing_of(track, ahead, q - direction * early, early);
    return goes_on_to(EndKind::joint, cross, direction, next, nearest_coordinate(ahead, position_at(track, cross)));
}

TrackEnd end_of_vertex(Terrain const& terrain, Contact contact, Track const& track, double radius, int direction) {
    Vertex const& vertex = terrain.vertex(contact.feature);
    // High q is the clockwise end of the exposed cone, a quarter turn before the edge that lies there.
    double const polar =
        direction == towards_high ? vertex.cone_high - vertex.cone_width - pi / 2 : vertex.cone_high + pi / 2;
    std::size_t best = 0;
    double nearest = 2 * pi;
    for (std::size_t i = 0; i < vertex.edges.size(); ++i) {
        double off = angle_of(vertex.edges[i].direction) - polar;
        off -= 2 * pi * std::floor(off / (2 * pi) + 0.5);
        if (std::abs(off) < nearest) {
            nearest = std::abs(off);
            best = i;
        }
    }
    IncidentEdge const& edge = vertex.edges[best];
    Contact const next = beside(edge, direction == towards_high);
    double const q = direction == towards_high ? track.length : 0;
    if (!fits(terrain, next, radius)) return {EndKind::wall, q, next, 0};
    return goes_on_to(EndKind::joint, q, direction, next, coordinate_at(terrain, next, edge.at_start, radius));
}

TrackEnd end_of(Terrain const& terrain, Contact contact, Track const& track, double radius, int direction) {
    if (track.closed) return {EndKind::none, direction * never, no_contact, 0};
    if (terrain.is_vertex(contact.feature)) return end_of_vertex(terrain, contact, track, radius, direction);
    return end_of_piece(terrain, contact, track, radius, direction);
}

SweepHit obstacle_on(Terrain const& terrain, Track const& track, double q, double radius, int direction, double until,
                     int own, double enough) {
    if (!track.straight) return first_contact(terrain, track, q, direction, radius, until, own, enough);
    Parabola const path{position_at(track, q), direction * track.along, Vec2::Zero()};
    return first_contact(terrain, path, radius, until, own, enough);
}

// The vertex in which the track of a piece ends, or -1.
int vertex_at(Terrain const& terrain, Contact contact, int direction) {
    if (terrain.is_vertex(contact.feature)) return -1;
    int const index =
        ends_at_start(contact, direction) ? terrain.start_vertex[contact.feature] : terrain.end_vertex[contact.feature];
    return index < 0 ? -1 : terrain.feature_of_vertex(index);
}

// Where the track goes on, what is met at its very end, as near as ends are told apart, is what it goes on to, or the
// vertex between. `early` (m) is how far before the track's own end it crosses the next, which begins as far before
// that.
bool is_passed_at(TrackEnd const& end, int vertex, SweepHit const& hit, double until, double early) {
    bool const goes_on = end.kind == EndKind::joint || end.kind == EndKind::corner;
    bool const is_next = hit.contact == end.next || (vertex >= 0 && hit.contact.feature == vertex);
    return goes_on && is_next && hit.time >= until - early - 8 * touch_reach;
}

}  // namespace

TrackEnds ends_of_track(Terrain const& terrain, Contact contact, Track const& track, double q, double radius,
                        double reach) {
    TrackEnds ends{end_of(terrain, contact, track, radius, towards_low),
                   end_of(terrain, contact, track, radius, towards_high)};
    double const whole_turn = 2 * pi * track.rho;
    for (int const direction : {towards_low, towards_high}) {
        TrackEnd& end = direction == towards_low ? ends.low : ends.high;
        double const until = track.closed ? whole_turn : std::max(0.0, direction * (end.q - q));
        SweepHit const found = obstacle_on(terrain, track, q, radius, direction, until, contact.feature, reach);
        double const early = track.closed ? 0 : std::max(0.0, direction > 0 ? track.length - end.q : end.q);
        int const vertex = vertex_at(terrain, contact, direction);
        if (found.time > until || is_passed_at(end, vertex, found, until, early)) continue;
        end = {EndKind::wall, q + direction * found.time, found.contact, 0};
    }
    return ends;
}

}  // namespace physics
