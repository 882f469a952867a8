// The terrain near a ball in the form that inner loops want: where a ball would touch it, and when it first does.
#pragma once

#include <vector>

#include "physics/terrain.h"

namespace physics {

// A line, a circular arc or a vertex (an arc of radius zero) with everything derived that every look at it needs.
struct Shape {
    enum class Kind { line, arc, vertex };
    Kind kind = Kind::line;
    int feature = 0;
    Vec2 origin = Vec2::Zero();  // line: its start; arc: its centre; vertex: the point
    Vec2 along = Vec2::UnitX();  // line: unit, to its end; arc: unit, from the centre to its middle
    double extent = 0;           // line: its length, m; arc: cosine of half the sweep, -2 for a whole circle
    double radius = 0;           // m, arc
    double turn = 1;             // arc: +1 counter-clockwise in the sense of travel, else -1
    Vec2 first = Vec2::UnitX();  // arc: unit, from the centre to its clockwise end
    Vec2 last = Vec2::UnitX();   // arc: unit, from the centre to its counter-clockwise end
    Material const* material = nullptr;
};
Shape shape_of(Terrain const& terrain, int feature);

// Where a ball's centre is, seen from a shape.
struct Sight {
    Vec2 normal = Vec2::Zero();  // unit, from the shape to the centre
    double distance = 0;         // m, from the surface to the centre
    int side = 1;
    bool faces = false;  // the shape's nearest point is its own, not a neighbour's
};
Sight sight_of(Terrain const& terrain, Shape const& shape, Vec2 const& centre);

// How the normal turns as the centre moves along at distance `radius`: 1/m, positive where the surface bulges.
double curvature_at(Shape const& shape, int side, double radius);

// Part of a centre's path: a parabola over [0, time].
struct Path {
    Vec2 from = Vec2::Zero();          // m
    Vec2 velocity = Vec2::Zero();      // m/s
    Vec2 acceleration = Vec2::Zero();  // m/s^2
    double time = 0;                   // s
    Vec2 at(double t) const { return from + t * (velocity + (0.5 * t) * acceleration); }
    Vec2 velocity_at(double t) const { return velocity + t * acceleration; }
};
// The parabola that leaves with `velocity` and arrives at `to` after `time`.
Path path_between(Vec2 const& from, Vec2 const& velocity, Vec2 const& to, double time);

// The first moment in [0, path.time] at which a ball on the path closes upon the shape; `never` if it does not.
// A ball that touches already and is pressed on closes at 0.
double closing_time(Terrain const& terrain, Shape const& shape, Path const& path, double radius);

// The contact of a ball that leaves `contact` over one of the piece's ends, standing off along `normal` there.
struct Passage {
    Contact to;           // the next piece, or the vertex
    bool smooth = false;  // a joint: the speed is kept
};
Passage passage_over(Terrain const& terrain, Contact contact, int vertex, Vec2 const& normal);

// Whether two pieces meet in a joint there.
bool meet_smoothly(Terrain const& terrain, int piece, int other);

// The side of a spoke's piece on which a ball lies that stands off the vertex along `normal`.
Contact contact_on(Spoke const& spoke, Vec2 const& normal);

// The shapes that a ball may meet while its centre stays within a box.
struct Surroundings {
    geometry::Box box;  // for the centre
    std::vector<Shape> shapes;
};
void look_around(Terrain const& terrain, Vec2 const& centre, double radius, double reach, Surroundings& surroundings);

}  // namespace physics
