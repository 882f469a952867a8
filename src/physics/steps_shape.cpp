#include "physics/steps_shape.h"

#include <algorithm>
#include <cmath>

#include "geometry/elementary.h"
#include "physics/leg.h"

namespace physics {

using geometry::dot;
using geometry::length;
using geometry::wedge;

namespace {

constexpr double touching = 1e-12;  // share of the lengths involved: gaps below this are rounding
constexpr double shape_unmoving = 1e-12;  // share of the speed: closing speeds below this are rounding
constexpr int refinements = 2;      // Newton steps from the chord's root to the parabola's

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
    shape.first = direction(arc.from + std::min(arc.sweep, 0.0));
    shape.last = direction(arc.from + std::max(arc.sweep, 0.0));
    return shape;
}

// A gap that changes as gap + rate t + half_bend t^2.
struct Gap {
    double gap = 0;
    double rate = 0;
    double half_bend = 0;
};

bool closes_now(Gap const& g, double speed, double scale) {
    if (g.gap > touching * scale) return false;
    if (g.rate < -shape_unmoving * speed) return true;
    return g.rate <= shape_unmoving * speed && g.half_bend < 0;
}

// The root at which the gap goes from open to closed.
double entry_time(Gap const& g) {
    double const square = g.rate * g.rate - 4 * g.half_bend * g.gap;
    if (square < 0) return never;
    double const root = std::sqrt(square);
    if (g.rate < 0) return 2 * g.gap / (root - g.rate);
    return g.half_bend < 0 ? (g.rate + root) / (-2 * g.half_bend) : never;
}

double line_closing_time(Shape const& shape, Path const& path, double radius) {
    Vec2 const d = path.from - shape.origin;
    double const signed_distance = wedge(shape.along, d);
    double const side = signed_distance < 0 ? -1 : 1;
    Gap const g{side * signed_distance - radius, side * wedge(shape.along, path.velocity),
                0.5 * side * wedge(shape.along, path.acceleration)};
    auto const faces = [&](double t) {
        double const x = dot(shape.along, path.at(t) - shape.origin);
        return x >= -vertex_reach && x <= shape.extent + vertex_reach;
    };
    if (closes_now(g, length(path.velocity), radius + length(d)) && faces(0)) return 0;
    double const t = entry_time(g);
    return t > 0 && t <= path.time && faces(t) ? t : never;
}

// When the path's chord enters (sense = -1) or leaves (+1) the circle about the origin, refined to the parabola.
double circle_crossing_time(Path const& path, Vec2 const& origin, double rho, double sense) {
    Vec2 const d = path.from - origin;
    Vec2 const v = path.velocity + (0.5 * path.time) * path.acceleration;
    double const a = dot(v, v), b = dot(d, v), distance = length(d);
    double const c = (distance - rho) * (distance + rho);
    double const square = b * b - a * c;
    if (square < 0 || a == 0) return never;
    // On the circle already, and by the parabola not crossing it now: the chord's root near 0 is none.
    bool const touches = std::abs(distance - rho) <= touching * (rho + distance);
    if (touches && (sense < 0 || b >= 0)) return never;
    double const root = std::sqrt(square);
    double t = never;
    if (sense < 0) t = b < 0 ? c / (root - b) : never;
    if (sense > 0) t = b > 0 ? -c / (root + b) : (root - b) / a;
    if (!(t >= 0) || t > path.time) return never;
    // A chord cuts a corner that the parabola may clear: where the parabola does not cross there is no crossing.
    for (int i = 0; i < refinements; ++i) {
        Vec2 const at = path.at(t) - origin;
        double const rate = dot(at, path.velocity_at(t));
        if (rate * sense <= 0) return never;
        t -= 0.5 * (dot(at, at) - rho * rho) / rate;
    }
    return t >= 0 && t <= path.time ? t : never;
}

// Whether a ball that faces the circle from the side of `sense` (+1 outside) is pressed on at once.
bool circle_closes_now(Shape const& shape, Path const& path, double rho, double sense) {
    Vec2 const d = path.from - shape.origin;
    double const distance = length(d);
    if (distance == 0) return false;
    double const rate = dot(path.velocity, d) / distance;
    double const across = wedge(d, path.velocity) / distance;
    double const bend = dot(path.acceleration, d) / distance + across * across / distance;
    Gap const g{sense * (distance - rho), sense * rate, 0.5 * sense * bend};
    return closes_now(g, length(path.velocity), rho + shape.radius);
}

double arc_closing_time(Terrain const& terrain, Shape const& shape, Path const& path, double radius) {
    double const distance = length(path.from - shape.origin);
    bool const outside = distance >= shape.radius;
    auto const faces = [&](double t) { return t <= path.time && sight_of(terrain, shape, path.at(t)).faces; };
    double const outer = shape.radius + radius, inner = shape.radius - radius;
    if (outside) {
        if (circle_closes_now(shape, path, outer, 1) && faces(0)) return 0;
        double const entry = circle_crossing_time(path, shape.origin, outer, -1);
        if (faces(entry)) return entry;
    } else if (inner > 0 && circle_closes_now(shape, path, inner, -1) && faces(0)) {
        return 0;
    }
    if (inner <= 0) return never;
    // From within, or right through the opening and on to the far side.
    double const leave = circle_crossing_time(path, shape.origin, inner, 1);
    return leave > 0 && faces(leave) ? leave : never;
}

double vertex_closing_time(Terrain const& terrain, Shape const& shape, Path const& path, double radius) {
    auto const faces = [&](double t) { return t <= path.time && sight_of(terrain, shape, path.at(t)).faces; };
    if (circle_closes_now(shape, path, radius, 1) && faces(0)) return 0;
    double const entry = circle_crossing_time(path, shape.origin, radius, -1);
    return faces(entry) ? entry : never;
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

Sight sight_of(Terrain const& terrain, Shape const& shape, Vec2 const& centre) {
    Vec2 const d = centre - shape.origin;
    if (shape.kind == Shape::Kind::line) {
        double const offset = wedge(shape.along, d), x = dot(shape.along, d);
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

Path path_between(Vec2 const& from, Vec2 const& velocity, Vec2 const& to, double time) {
    if (time <= 0) return {from, velocity, Vec2::Zero(), 0};
    return {from, velocity, (2 / time) * ((to - from) / time - velocity), time};
}

double closing_time(Terrain const& terrain, Shape const& shape, Path const& path, double radius) {
    switch (shape.kind) {
        case Shape::Kind::line:
            return line_closing_time(shape, path, radius);
        case Shape::Kind::arc:
            return arc_closing_time(terrain, shape, path, radius);
        case Shape::Kind::vertex:
            return vertex_closing_time(terrain, shape, path, radius);
    }
    return never;
}

Contact contact_on(Spoke const& spoke, Vec2 const& normal) {
    double const left = wedge(spoke.direction, normal) * (spoke.at_start ? 1 : -1);
    return {spoke.piece, left >= 0 ? 1 : -1};
}

Passage passage_over(Terrain const& terrain, Contact contact, int vertex, Vec2 const& normal) {
    Passage passage{{terrain.feature_of_vertex(vertex), 1}, false};
    for (Spoke const& spoke : terrain.vertices[vertex].spokes) {
        if (spoke.piece == contact.feature) continue;
        double const rise = dot(spoke.direction, normal);
        if (std::abs(rise) <= joint_turn) return {contact_on(spoke, normal), true};
        if (rise > 0) passage.to = contact_on(spoke, normal);
    }
    return passage;
}

bool meet_smoothly(Terrain const& terrain, int piece, int other) {
    if (terrain.is_vertex(piece) || terrain.is_vertex(other)) return false;
    for (int const vertex : {terrain.start_vertex[piece], terrain.end_vertex[piece]}) {
        if (vertex < 0 || (vertex != terrain.start_vertex[other] && vertex != terrain.end_vertex[other])) continue;
        for (Spoke const& a : terrain.vertices[vertex].spokes)
            for (Spoke const& b : terrain.vertices[vertex].spokes)
                if (a.piece == piece && b.piece == other && dot(a.direction, b.direction) < 0 &&
                    std::abs(wedge(a.direction, b.direction)) <= joint_turn)
                    return true;
    }
    return false;
}

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

}  // namespace physics
