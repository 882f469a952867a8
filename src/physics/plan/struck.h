// A ball among the points of terrain that it touches, while impacts change its state: what the files of this room that
// decide what becomes of it share.
#pragma once

#include <optional>
#include <vector>

#include "physics/contact/contacts_at.h"
#include "physics/motion/impact.h"
#include "physics/plan/transition.h"

namespace physics {

// Normals nearer than this to parallel leave a ball free to move along both surfaces.
inline constexpr double parallel = 1e-9;
// A depth up to here, in m, is the rounding of one bounce.
inline constexpr double least_depth = 1e-11;
// Forces below this share of the field are rounding.
inline constexpr double hold_rounding = 1e-12;

// A ball among its supports, while blows change its state.
struct Struck {
    State state;
    std::vector<ContactPoint> touched;  // all that is touched, and
    std::vector<ContactPoint> points;   // of what shares a normal the one that counts
    Contact known;                      // that the caller says is touched
    std::vector<Transition::ContactEvent> blows;
    double still = 0;             // m/s: slower than this along a normal it neither closes nor parts
    double rounding = 0;          // m/s: slower than this, after what happens here, is not moving
    std::optional<Vec2> gripped;  // the normal at which an impact stopped the slip, if nothing came after
};

// Where it is, before any impact. `known` is the contact that the caller knows to be touched, or no_contact.
Struck struck_at(MotionContext const& context, State const& state, Contact known);
// Of what is touched, which points count for the velocity there is now.
void choose_supports(MotionContext const& context, Struck& struck);
// Impacts until nothing closes; what would go on for ever ends with the ball standing.
void strike_all(MotionContext const& context, Struck& struck);

// Along a unit normal and across it.
ContactSpeeds speeds_at(MotionContext const& context, State const& state, Vec2 const& normal);
// The ball on the track of support i.
SurfaceState surface_state_on(MotionContext const& context, Struck const& struck, std::size_t i);
// On along the surface, or in flight where it does not press.
Transition ride_from(MotionContext const& context, SurfaceState const& free_state, double time);

// No way out: the ball jams if anything presses on it, else it flies.
Transition stuck(MotionContext const& context, Struck const& struck, std::vector<std::size_t> const& kept, double time);
// A standing ball that one socket or two supports hold: at rest, or spinning until friction has stopped it
// (physics.md 7.2).
std::optional<Transition> wedged(MotionContext const& context, Struck const& struck,
                                 std::vector<std::size_t> const& kept, double time);
// Along one of several surfaces that a ball keeps to, or else standing: held by them, let go by one of them, or jammed.
Transition among_several(MotionContext const& context, Struck& struck, std::vector<std::size_t> const& kept,
                         double time);
// Bounces to and fro between surfaces that are not parallel die out like a geometric series, the speeds along them
// included: where none of them would be seen any more the ball stands, and where they crowd it does so as soon as they
// do not leave the reach of touch.
bool stands_among_several(MotionContext const& context, Struck const& struck);

}  // namespace physics
