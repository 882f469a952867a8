// Contacts: which features a ball touches where it is.
#pragma once

#include <vector>

#include "physics/contact/first_contact.h"

namespace physics {

// A feature nearer to the ball's rim than touch_reach, or inside of it. The gap's second derivative is a . normal +
// curvature (v . t)^2, with t = (n.y, -n.x).
struct ContactPoint {
    Contact contact;
    Vec2 normal = Vec2::UnitY();  // unit, from terrain to ball
    double gap = 0;               // m, below 0 inside
    double curvature = 0;        // 1/m: of the way on which the ball keeps to it, positive where that turns away from n
    bool ends_forwards = false;  // the feature ends here for a ball that goes along t,
    bool ends_backwards = false;  // or against it
    // Of a socket, an arc of the ball's own radius around its centre: where its normals begin, and how far they turn.
    double normals_from = 0, normals_turn = 0;  // rad; no turn: one normal
};

// Of the gap, m/s^2: a . normal + curvature (v . t)^2, with t = (n.y, -n.x).
double second_derivative(ContactPoint const& point, Vec2 const& velocity, Vec2 const& acceleration);

// All of them, in order of features. From a socket, an arc of the ball's own radius around its centre, several between
// its ends, where vertices or neighbours push: together they push wherever the arc does.
std::vector<ContactPoint> contacts_at(Terrain const& terrain, Vec2 const& centre, double radius);

// Of supports that share a normal, as the pieces do that meet at a joint, the one to which a ball keeps that has this
// velocity and this acceleration: one that does not end in the direction of its motion, and of those the one that
// presses most. In order of the first features.
std::vector<ContactPoint> kept_apart(std::vector<ContactPoint> const& all, Vec2 const& velocity,
                                     Vec2 const& acceleration, double rounding);

// Whether the support ends here for a ball that moves with this velocity or, if that is less than `rounding` (m/s), is
// drawn by this acceleration.
bool is_left_behind(ContactPoint const& point, Vec2 const& velocity, Vec2 const& acceleration, double rounding);

}  // namespace physics
