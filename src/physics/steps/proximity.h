// The terrain near a ball in the form that inner loops want: where a ball would touch it.
#pragma once

#include <vector>

#include "physics/terrain/terrain.h"

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
    Material const* material = nullptr;
};
Shape shape_of(Terrain const& terrain, int feature);

// Where a ball's centre is, seen from a shape.
struct Proximity {
    Vec2 normal = Vec2::Zero();  // unit, from the shape to the centre
    double distance = 0;         // m, from the surface to the centre
    int side = 1;
    bool faces = false;  // the shape's nearest point is its own, not a neighbour's
};
Proximity proximity_of(Terrain const& terrain, Shape const& shape, Vec2 const& centre);

// How the normal turns as the centre moves along at distance `radius`: 1/m, positive where the surface bulges.
double curvature_at(Shape const& shape, int side, double radius);

// Whether two pieces meet in a joint there.
bool meet_smoothly(Terrain const& terrain, int piece, int other);

// The shapes that a ball may meet while its centre stays within a box.
struct Surroundings {
    geometry::Box box;  // for the centre
    std::vector<Shape> shapes;
};
void look_around(Terrain const& terrain, Vec2 const& centre, double radius, double reach, Surroundings& surroundings);
// Those about the way from one place to another, looked up anew only when it leaves those known.
std::vector<Shape> const& shapes_on_the_way(Terrain const& terrain, Vec2 const& from, Vec2 const& to, double radius,
                                            Surroundings& surroundings);

}  // namespace physics
