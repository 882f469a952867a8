// A ball's way through a substep among fixed terrain: flight, riding on one surface, impacts, from one to the next.
#pragma once

#include "physics/steps_impact.h"
#include "physics/steps_shape.h"
#include "physics/stepping.h"

namespace physics {

struct Traveller {
    int index = 0;
    Ball const* ball = nullptr;
    Field const* field = nullptr;
    State state;
    Contact contact;
    Surroundings near;
    Impulse impulse;      // per kg, of the last stretch on the surface
    bool let_go = false;  // its surface has just let go of it
    bool still = false;   // it has stood on its surface without moving
};

// The terrain and the time: what is the same for all balls of a substep.
struct Substep {
    Terrain const& terrain;
    double since = 0;   // s
    double length = 0;  // s, where it ends
    double pace = 0;    // s, from one substep to the next; travel to a moment within one has a shorter length
    Trail<Event>& events;
};

// Moves the traveller from `since` seconds into the substep to its end.
void travel(Substep const& substep, Traveller& traveller, double since);

// What travel() is made of, each answering how much of `left` seconds it used.
double fly(Substep const& substep, Traveller& traveller, double left);
double ride(Substep const& substep, Traveller& traveller, double left);

// Meets a shape that the path closes upon: bounces, lands, or glides over a joint. `now` is seconds into the substep.
void arrive(Substep const& substep, Traveller& traveller, Shape const& shape, double now);

// The first shape that a path of the traveller's centre closes upon, other than the one it is on.
struct Meeting {
    double time = never;
    Shape const* shape = nullptr;
};
Meeting first_meeting(Substep const& substep, Traveller& traveller, Path const& path);

// The shapes about the path from where the traveller is to `to`, looked up anew only when it leaves those known.
std::vector<Shape> const& shapes_on_the_way(Terrain const& terrain, Traveller& traveller, Vec2 const& to);

// On to another surface, or to none, with the event that this is.
void change_contact(Substep const& substep, Traveller& traveller, EventKind kind, Contact contact, double now);

// Onto the surface, exactly at distance of the radius.
void seat(Terrain const& terrain, Shape const& shape, Traveller& traveller);

// Rests or spins between two surfaces, pressed against both, for `time` seconds.
void wedge_between(Substep const& substep, Traveller& traveller, Shape const& one, Shape const& other, double time);

// Stops a ball that only rocks between two surfaces that can hold it: it is slower than what acts on it makes it within
// two substeps, and pressed from rest it stays where it is.
void settle_between(Substep const& substep, Traveller& traveller);

// Flight, rest, roll or slide, by what the traveller touches and how it moves there.
Phase phase_of(Traveller const& traveller);

// A stiff spring bends the path: short enough a part of `left` that a parabola follows it.
double part_of(Substep const& substep, Traveller const& traveller, double left);

double closing_speed(Terrain const& terrain, Shape const& shape, Traveller const& traveller);

}  // namespace physics
