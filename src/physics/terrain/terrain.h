// The ground: curves that balls touch from both sides, the vertices where they meet, and who lies near a box.
#pragma once

#include <span>
#include <vector>

#include "geometry/box_tree.h"
#include "geometry/curve.h"

namespace physics {

using geometry::Vec2;

struct Material {
    double friction = 0.9;          // Coulomb; infinity = full grip
    double restitution = 0;         // e in [0, 1]
    double rolling_resistance = 0;  // c: the couple against rolling is c N r
};

// One curve of the terrain. It has two sides: +1 to the left of its sense of travel, -1 to the right.
struct Piece {
    geometry::Curve curve;
    Material material;
    int surface = 0;  // which element of the level it belongs to, for names in traces
};

// One end of a piece, seen from the vertex it ends in.
struct IncidentEdge {
    int piece = 0;
    bool at_start = true;            // the piece starts here
    Vec2 direction = Vec2::UnitX();  // unit, from the vertex into the piece
};

struct Vertex {
    Vec2 point = Vec2::Zero();
    std::vector<IncidentEdge> edges;                             // counter-clockwise by direction
    double cone_high = 0;                                        // rad: exposed directions run clockwise from here,
    double cone_width = 0;                                       // rad: this far; 0 on flat and concave joints
    Vec2 first_edge = Vec2::UnitX(), last_edge = Vec2::UnitX();  // the edges at both sides of what is exposed
    Material material{};                                         // the greatest of each number among its pieces'
    int surface = 0;                                             // the first among its pieces'
};

// Features are counted pieces first, then vertices.
struct Terrain {
    std::vector<Piece> pieces;
    std::vector<Vertex> vertices;
    std::vector<int> start_vertex, end_vertex;  // by piece; -1 on a whole circle
    geometry::BoxTree tree;                     // over the pieces
    geometry::Box bounds;

    bool is_vertex(int feature) const { return feature >= static_cast<int>(pieces.size()); }
    Vertex const& vertex(int feature) const { return vertices[feature - pieces.size()]; }
    int feature_of_vertex(int vertex) const { return static_cast<int>(pieces.size()) + vertex; }
};

// Ends within `vertex_reach` of each other become one vertex, and chains of such ends too: terrain_merge.h.
inline constexpr double vertex_reach = 1e-6;  // m, docs/levels.md
// Turns of the tangent below this are joints, at which the speed is kept; above it they are corners.
inline constexpr double joint_turn = 1e-3;  // rad, docs/levels.md

Terrain terrain_of(std::vector<Piece> drawn);

// Where surfaces lie on each other or meet, the greatest of each of their numbers counts.
void take_over(Material& material, Material const& other);
Material const& material_of(Terrain const& terrain, int feature);
int surface_of(Terrain const& terrain, int feature);

// Whether a ball whose centre lies in direction `normal` from the vertex has no nearer point on the vertex's pieces:
// only then can it touch the vertex itself. Flat and concave joints have no such direction, so nothing trips on them.
bool exposes(Vertex const& vertex, Vec2 const& normal);

// The polar angle of a vector, rad, as arcs and tracks count it.
double angle_of(Vec2 const& direction);

// Which side and feature a ball touches: feature -1 is none. A vertex has one side, +1.
struct Contact {
    int feature = -1;
    int side = 0;
    bool operator==(Contact const&) const = default;
};
inline constexpr Contact no_contact{};

// The path of a ball's centre while it touches one side of a feature: a line, or a circle about `origin`.
// The coordinate q (m) grows along the tangent t = (n.y, -n.x), with n the unit normal from terrain to ball:
// a rolling ball's angle is then always angle0 - (q - q0)/r (physics.md 1.1).
struct Track {
    bool straight = true;
    Vec2 origin = Vec2::Zero();  // line: the centre at q = 0; circle: the circle's centre
    Vec2 along = Vec2::UnitX();  // line: t
    double rho = 0;              // circle: radius of the centre's path
    double sense = 1;            // circle: n = sense * (cos phi, sin phi); +1 the ball is outside, -1 inside
    double phi0 = 0;             // circle: phi at q = 0; phi = phi0 - sense * q / rho
    double length = 0;           // q runs from 0 to length
    bool closed = false;         // a whole circle: q has no ends
};
// A concave arc no wider than the ball, or wider by less than this, has no track: fits() says so. A ball at the centre
// of such an arc touches all of it, as in a socket.
inline constexpr double socket_play = 1.25e-6;  // m, more than ends that are one: a play of 1e-6 as drawn is within it
bool fits(Terrain const& terrain, Contact contact, double radius);
Track track_of(Terrain const& terrain, Contact contact, double radius);

struct TrackPlace {
    Vec2 position = Vec2::Zero();  // m, the centre
    Vec2 normal = Vec2::Zero();    // unit
};
TrackPlace place_at(Track const& track, double q);
Vec2 normal_at(Track const& track, double q);
Vec2 position_at(Track const& track, double q);
double nearest_coordinate(Track const& track, Vec2 const& centre);

}  // namespace physics
