#include "physics/terrain/terrain.h"

#include <algorithm>

#include "geometry/elementary.h"
#include "physics/terrain/terrain_merge.h"

namespace physics {

using geometry::Arc;
using geometry::pi;
using geometry::Segment;

double angle_of(Vec2 const& direction) { return geometry::arctangent(direction.y(), direction.x()); }

namespace {

constexpr double exposed_slack = 1e-12;  // rounding of a unit vector's scalar product
// rad: narrower an edge is not seen: the reach of touch is wider than it, for balls of up to 2 km
constexpr double flat_cone = 1e-12;

struct AngledEdge {
    double angle;  // rad
    std::size_t position;
    IncidentEdge edge;
};

// Into `angled`, kept between vertices for its room.
void sort_edges(Vertex& vertex, std::vector<AngledEdge>& angled) {
    angled.clear();
    for (IncidentEdge const& edge : vertex.edges) angled.push_back({angle_of(edge.direction), angled.size(), edge});
    std::sort(angled.begin(), angled.end(), [](AngledEdge const& a, AngledEdge const& b) {
        return a.angle < b.angle || (a.angle == b.angle && a.position < b.position);
    });
    for (std::size_t i = 0; i < angled.size(); ++i) vertex.edges[i] = angled[i].edge;
}

// The widest gap between neighbouring edges, less a quarter turn at each side, is what the vertex exposes.
void set_cone(Vertex& vertex, std::vector<AngledEdge> const& angled) {
    double widest = 0;
    auto const count = angled.size();
    for (std::size_t i = 0; i < count; ++i) {
        AngledEdge const &from = angled[i], &next = angled[(i + 1) % count];
        double const to = i + 1 == count ? next.angle + 2 * pi : next.angle;
        if (to - from.angle - pi > widest) {
            widest = to - from.angle - pi;
            vertex.cone_high = to - pi / 2;
            vertex.first_edge = from.edge.direction;
            vertex.last_edge = next.edge.direction;
        }
    }
    vertex.cone_width = widest > flat_cone ? widest : 0;
}

// Of all its pieces, so that no order matters.
void set_material(Terrain const& terrain, Vertex& vertex) {
    for (std::size_t i = 0; i < vertex.edges.size(); ++i) {
        Piece const& piece = terrain.pieces[vertex.edges[i].piece];
        if (i == 0) vertex.material = piece.material, vertex.surface = piece.surface;
        take_over(vertex.material, piece.material);
        vertex.surface = std::min(vertex.surface, piece.surface);
    }
}

Track line_track(Segment const& segment, int side, double radius) {
    Track track;
    Vec2 const way = segment.end - segment.start;
    track.length = geometry::length(way);
    track.along = way * (side / track.length);
    Vec2 const normal = geometry::turned_left(track.along);
    track.origin = (side > 0 ? segment.start : segment.end) + radius * normal;
    return track;
}

Track arc_track(Arc const& arc, int side, double radius) {
    Track track;
    track.straight = false;
    track.origin = arc.centre;
    bool const inside = (side > 0) == (arc.sweep > 0);
    track.sense = inside ? -1 : 1;
    track.rho = arc.radius + track.sense * radius;
    bool const starts_at_from = (arc.sweep > 0) == inside;
    track.phi0 = starts_at_from ? arc.from : arc.from + arc.sweep;
    track.length = std::abs(arc.sweep) * track.rho;
    track.closed = geometry::is_whole_circle(arc);
    return track;
}

Track vertex_track(Vertex const& vertex, double radius) {
    Track track;
    track.straight = false;
    track.origin = vertex.point;
    track.rho = radius;
    track.phi0 = vertex.cone_high;
    track.length = vertex.cone_width * radius;
    return track;
}

}  // namespace

void take_over(Material& material, Material const& other) {
    material.friction = std::max(material.friction, other.friction);
    material.restitution = std::max(material.restitution, other.restitution);
    material.rolling_resistance = std::max(material.rolling_resistance, other.rolling_resistance);
}

Terrain terrain_of(std::vector<Piece> drawn) {
    MergedPieces all = merged(std::move(drawn));
    Terrain terrain;
    terrain.pieces = std::move(all.pieces);
    terrain.start_vertex = std::move(all.start);
    terrain.end_vertex = std::move(all.end);
    terrain.tree = std::move(all.tree);
    terrain.vertices.resize(all.points.size());
    for (std::size_t i = 0; i < all.points.size(); ++i) terrain.vertices[i].point = all.points[i];
    std::vector<int> degrees(all.points.size());
    for (std::size_t i = 0; i < terrain.pieces.size(); ++i) {
        if (terrain.start_vertex[i] < 0) continue;
        ++degrees[terrain.start_vertex[i]];
        ++degrees[terrain.end_vertex[i]];
    }
    for (std::size_t i = 0; i < degrees.size(); ++i) terrain.vertices[i].edges.reserve(degrees[i]);
    for (int i = 0; i < static_cast<int>(terrain.pieces.size()); ++i) {
        geometry::Curve const& curve = terrain.pieces[i].curve;
        terrain.bounds = united(terrain.bounds, geometry::box_of(curve));
        if (terrain.start_vertex[i] < 0) continue;
        terrain.vertices[terrain.start_vertex[i]].edges.push_back({i, true, geometry::tangent_at_start(curve)});
        terrain.vertices[terrain.end_vertex[i]].edges.push_back({i, false, -geometry::tangent_at_end(curve)});
    }
    std::vector<AngledEdge> angled;
    for (Vertex& vertex : terrain.vertices) {
        sort_edges(vertex, angled);
        set_cone(vertex, angled);
        set_material(terrain, vertex);
    }
    return terrain;
}

Material const& material_of(Terrain const& terrain, int feature) {
    return terrain.is_vertex(feature) ? terrain.vertex(feature).material : terrain.pieces[feature].material;
}

int surface_of(Terrain const& terrain, int feature) {
    return terrain.is_vertex(feature) ? terrain.vertex(feature).surface : terrain.pieces[feature].surface;
}

bool exposes(Vertex const& vertex, Vec2 const& normal) {
    if (vertex.cone_width == 0) return false;
    for (IncidentEdge const& edge : vertex.edges)
        if (geometry::dot(normal, edge.direction) > exposed_slack) return false;
    return true;
}

bool fits(Terrain const& terrain, Contact contact, double radius) {
    if (terrain.is_vertex(contact.feature)) return true;
    auto const* arc = std::get_if<Arc>(&terrain.pieces[contact.feature].curve);
    bool const inside = arc != nullptr && (contact.side > 0) == (arc->sweep > 0);
    return !inside || arc->radius > radius + socket_play;
}

Track track_of(Terrain const& terrain, Contact contact, double radius) {
    if (terrain.is_vertex(contact.feature)) return vertex_track(terrain.vertex(contact.feature), radius);
    geometry::Curve const& curve = terrain.pieces[contact.feature].curve;
    if (auto const* segment = std::get_if<Segment>(&curve)) return line_track(*segment, contact.side, radius);
    return arc_track(std::get<Arc>(curve), contact.side, radius);
}

Vec2 normal_at(Track const& track, double q) {
    if (track.straight) return geometry::turned_left(track.along);
    auto const [sine, cosine] = geometry::sine_cosine(track.phi0 - track.sense * q / track.rho);
    return {track.sense * cosine, track.sense * sine};
}

TrackPlace place_at(Track const& track, double q) {
    Vec2 const normal = normal_at(track, q);
    if (track.straight) return {track.origin + q * track.along, normal};
    return {track.origin + (track.sense * track.rho) * normal, normal};
}

Vec2 position_at(Track const& track, double q) { return place_at(track, q).position; }

double nearest_coordinate(Track const& track, Vec2 const& centre) {
    Vec2 const from_origin = centre - track.origin;
    if (track.straight) return geometry::dot(from_origin, track.along);
    double const span = track.length / track.rho;
    double turn = track.sense * (track.phi0 - angle_of(from_origin));
    // The representative nearest to the middle of the track, so that a point just before the start counts as negative.
    turn -= 2 * pi * std::floor((turn - span / 2) / (2 * pi) + 0.5);
    return turn * track.rho;
}

}  // namespace physics
