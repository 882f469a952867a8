#include "physics/terrain.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

#include "geometry/elementary.h"

namespace physics {

using geometry::Arc;
using geometry::pi;
using geometry::Segment;

double angle_of(Vec2 const& direction) { return geometry::arctangent(direction.y(), direction.x()); }

namespace {

constexpr double exposed_slack = 1e-12;       // rounding of a unit vector's scalar product
constexpr double flat_cone = 1e-10;           // rad, cones narrower than this are rounding of a flat joint
constexpr double whole_circle_slack = 1e-12;  // rad

bool is_whole_circle(geometry::Curve const& curve) {
    auto const* arc = std::get_if<Arc>(&curve);
    return arc != nullptr && std::abs(arc->sweep) >= 2 * pi - whole_circle_slack;
}

// Finds the vertex at a point, in cells as wide as the reach, so that only neighbours need a look.
class VertexFinder {
public:
    explicit VertexFinder(std::vector<Vertex>& vertices) : vertices_(vertices) {}

    int at(Vec2 const& point) {
        auto const column = static_cast<std::int64_t>(std::floor(point.x() / vertex_reach));
        auto const row = static_cast<std::int64_t>(std::floor(point.y() / vertex_reach));
        for (std::int64_t i = column - 1; i <= column + 1; ++i)
            for (std::int64_t j = row - 1; j <= row + 1; ++j)
                if (int const found = in_cell(i, j, point); found >= 0) return found;
        vertices_.push_back({point, {}});
        int const index = static_cast<int>(vertices_.size()) - 1;
        cells_[key(column, row)].push_back(index);
        return index;
    }

private:
    static std::uint64_t key(std::int64_t column, std::int64_t row) {
        return static_cast<std::uint64_t>(column) * 0x9E3779B97F4A7C15ULL + static_cast<std::uint64_t>(row);
    }
    int in_cell(std::int64_t column, std::int64_t row, Vec2 const& point) const {
        auto const cell = cells_.find(key(column, row));
        if (cell == cells_.end()) return -1;
        for (int const vertex : cell->second)
            if (geometry::length(vertices_[vertex].point - point) <= vertex_reach) return vertex;
        return -1;
    }

    std::vector<Vertex>& vertices_;
    std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

void sort_spokes(Vertex& vertex) {
    std::stable_sort(vertex.spokes.begin(), vertex.spokes.end(),
                     [](Spoke const& a, Spoke const& b) { return angle_of(a.direction) < angle_of(b.direction); });
}

// The widest gap between neighbouring spokes, less a quarter turn at each side, is what the vertex exposes.
void set_cone(Vertex& vertex) {
    double widest = 0;
    auto const count = vertex.spokes.size();
    for (std::size_t i = 0; i < count; ++i) {
        double const from = angle_of(vertex.spokes[i].direction);
        double to = angle_of(vertex.spokes[(i + 1) % count].direction);
        if (i + 1 == count) to += 2 * pi;
        if (to - from - pi > widest) {
            widest = to - from - pi;
            vertex.cone_high = to - pi / 2;
        }
    }
    vertex.cone_width = widest > flat_cone ? widest : 0;
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
    track.closed = is_whole_circle(arc);
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

Terrain terrain_of(std::vector<Piece> pieces) {
    Terrain terrain;
    // What has no length has neither a tangent nor a side to touch.
    std::erase_if(pieces, [](Piece const& piece) { return !(geometry::length_of(piece.curve) > 0); });
    terrain.pieces = std::move(pieces);
    auto const count = terrain.pieces.size();
    terrain.start_vertex.assign(count, -1);
    terrain.end_vertex.assign(count, -1);
    VertexFinder finder(terrain.vertices);
    std::vector<geometry::Curve> curves;
    curves.reserve(count);
    for (int i = 0; i < static_cast<int>(count); ++i) {
        geometry::Curve const& curve = terrain.pieces[i].curve;
        curves.push_back(curve);
        terrain.bounds = united(terrain.bounds, geometry::box_of(curve));
        if (is_whole_circle(curve)) continue;
        terrain.start_vertex[i] = finder.at(geometry::start_of(curve));
        terrain.end_vertex[i] = finder.at(geometry::end_of(curve));
        terrain.vertices[terrain.start_vertex[i]].spokes.push_back({i, true, geometry::tangent_at_start(curve)});
        terrain.vertices[terrain.end_vertex[i]].spokes.push_back({i, false, -geometry::tangent_at_end(curve)});
    }
    for (Vertex& vertex : terrain.vertices) {
        sort_spokes(vertex);
        set_cone(vertex);
    }
    terrain.tree = geometry::BoxTree(std::span<geometry::Curve const>(curves));
    return terrain;
}

namespace {
int first_piece_of(Terrain const& terrain, int feature) {
    if (!terrain.is_vertex(feature)) return feature;
    int first = terrain.vertex(feature).spokes.front().piece;
    for (Spoke const& spoke : terrain.vertex(feature).spokes) first = std::min(first, spoke.piece);
    return first;
}
}  // namespace

Material const& material_of(Terrain const& terrain, int feature) {
    return terrain.pieces[first_piece_of(terrain, feature)].material;
}

int surface_of(Terrain const& terrain, int feature) { return terrain.pieces[first_piece_of(terrain, feature)].surface; }

bool exposes(Vertex const& vertex, Vec2 const& normal) {
    if (vertex.cone_width == 0) return false;
    for (Spoke const& spoke : vertex.spokes)
        if (geometry::dot(normal, spoke.direction) > exposed_slack) return false;
    return true;
}

bool fits(Terrain const& terrain, Contact contact, double radius) {
    if (terrain.is_vertex(contact.feature)) return true;
    auto const* arc = std::get_if<Arc>(&terrain.pieces[contact.feature].curve);
    bool const inside = arc != nullptr && (contact.side > 0) == (arc->sweep > 0);
    return !inside || arc->radius > radius * (1 + 1e-9);
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
