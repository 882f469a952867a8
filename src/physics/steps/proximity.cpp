#include "physics/steps/proximity.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"

namespace physics {

using geometry::cross;
using geometry::dot;
using geometry::length;

namespace {

constexpr double paths_ahead = 24;  // how many times the way ahead the surroundings are looked up

Vec2 direction(double angle) {
    auto const [sine, cosine] = geometry::sine_cosine(angle);
    return {cosine, sine};
}

Shape shape_of_curve(geometry::Segment const& segment) {
    Shape shape;
    shape.origin = segment.start;
    shape.extent = length(segment.end - segment.start);
    shape.along = (segment.end - segment.start) / shape.extent;
    return shape;
}

Shape shape_of_curve(geometry::Arc const& arc) {
    Shape shape;
    shape.kind = Shape::Kind::arc;
    shape.origin = arc.centre;
    shape.radius = arc.radius;
    shape.turn = arc.sweep < 0 ? -1 : 1;
    double const half = std::abs(arc.sweep) / 2;
    double const slack = vertex_reach / arc.radius;
    shape.along = direction(arc.from + arc.sweep / 2);
    shape.extent = half + slack < geometry::pi ? geometry::sine_cosine(half + slack).cosine : -2;
    return shape;
}

}  // namespace

Shape shape_of(Terrain const& terrain, int feature) {
    Shape shape;
    if (terrain.is_vertex(feature)) {
        shape.kind = Shape::Kind::vertex;
        shape.origin = terrain.vertex(feature).point;
    } else {
        shape = std::visit([](auto const& curve) { return shape_of_curve(curve); }, terrain.pieces[feature].curve);
    }
    shape.feature = feature;
    shape.material = &material_of(terrain, feature);
    return shape;
}

Proximity proximity_of(Terrain const& terrain, Shape const& shape, Vec2 const& centre) {
    Vec2 const d = centre - shape.origin;
    if (shape.kind == Shape::Kind::line) {
        double const offset = cross(shape.along, d), x = dot(shape.along, d);
        int const side = offset < 0 ? -1 : 1;
        return {side * geometry::turned_left(shape.along), std::abs(offset), side,
                x >= -vertex_reach && x <= shape.extent + vertex_reach};
    }
    double const distance = length(d);
    if (distance == 0) return {};
    Vec2 const outward = d / distance;
    if (shape.kind == Shape::Kind::vertex)
        return {outward, distance, 1, exposes(terrain.vertex(shape.feature), outward)};
    bool const inside = distance < shape.radius;
    return {inside ? Vec2(-outward) : outward, std::abs(distance - shape.radius), inside == (shape.turn > 0) ? 1 : -1,
            dot(outward, shape.along) >= shape.extent};
}

double curvature_at(Shape const& shape, int side, double radius) {
    if (shape.kind == Shape::Kind::line) return 0;
    if (shape.kind == Shape::Kind::vertex) return 1 / radius;
    bool const inside = (side > 0) == (shape.turn > 0);
    return inside ? -1 / (shape.radius - radius) : 1 / (shape.radius + radius);
}

bool meet_smoothly(Terrain const& terrain, int piece, int other) {
    if (terrain.is_vertex(piece) || terrain.is_vertex(other)) return false;
    for (int const vertex : {terrain.start_vertex[piece], terrain.end_vertex[piece]}) {
        if (vertex < 0 || (vertex != terrain.start_vertex[other] && vertex != terrain.end_vertex[other])) continue;
        for (IncidentEdge const& a : terrain.vertices[vertex].edges)
            for (IncidentEdge const& b : terrain.vertices[vertex].edges)
                if (a.piece == piece && b.piece == other && dot(a.direction, b.direction) < 0 &&
                    std::abs(cross(a.direction, b.direction)) <= joint_turn)
                    return true;
    }
    return false;
}

namespace {

bool within(geometry::Box const& box, Vec2 const& p) {
    return p.x() >= box.low.x() && p.x() <= box.high.x() && p.y() >= box.low.y() && p.y() <= box.high.y();
}

}  // namespace

void look_around(Terrain const& terrain, Vec2 const& centre, double radius, double reach, Surroundings& surroundings) {
    surroundings.box = {centre - Vec2::Constant(reach), centre + Vec2::Constant(reach)};
    surroundings.shapes.clear();
    auto const add = [&](int feature) {
        for (Shape const& shape : surroundings.shapes)
            if (shape.feature == feature) return;
        surroundings.shapes.push_back(shape_of(terrain, feature));
    };
    terrain.tree.each_overlapping(grown(surroundings.box, radius * (1 + 1e-6)), [&](int piece) {
        add(piece);
        for (int const vertex : {terrain.start_vertex[piece], terrain.end_vertex[piece]})
            if (vertex >= 0 && terrain.vertices[vertex].cone_width > 0) add(terrain.feature_of_vertex(vertex));
    });
}

std::vector<Shape> const& shapes_on_the_way(Terrain const& terrain, Vec2 const& from, Vec2 const& to, double radius,
                                            Surroundings& surroundings) {
    if (!within(surroundings.box, from) || !within(surroundings.box, to))
        look_around(terrain, from, radius, radius + paths_ahead * length(to - from), surroundings);
    return surroundings.shapes;
}

}  // namespace physics
