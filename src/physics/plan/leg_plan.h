// Leg plans: one leg of one ball in closed form, from now to the event that ends it.
#pragma once

#include "physics/world/force_field.h"
#include "physics/motion/leg.h"
#include "physics/world/ball_plan.h"

namespace physics {

struct LegPlan {
    Leg leg;
    LegEnd end;
};

// What a plan depends on besides the ball's state.
struct MotionContext {
    Terrain const& terrain;
    Ball const& ball;
    Field field;
    // Of bounces just before (planned_balls.h): they have crowded and end now, restitution counts for nothing; or there
    // were many, and those to come, if as short, are summed.
    bool crowded = false, many = false;
    double horizon = never;  // s from now: what comes later need not be known
};

// A ball on its track.
struct SurfaceState {
    Contact contact;
    Track track;
    double q = 0;      // m
    double speed = 0;  // m/s, along t
    double rim = 0;    // m/s, in the rolling sense: -r spin
    double angle = 0;  // rad
    double slip() const { return speed - rim; }
};
State state_of(MotionContext const& context, SurfaceState const& on_track);

// A hop lower than this many radii is not seen; nor is, on a straight track where gravity alone acts and the sum of the
// bounces to come is exact, one lower than the second.
inline constexpr double lowest_hop = 1e-13;
inline constexpr double lowest_hop_of_sums = 1e-12;
// Where bounces are many hops shorter than this are summed whatever their height, s.
inline constexpr double longest_of_many = 1.0 / 60'000;
// The speed with which a ball in this field does not get farther than the lowest hop, m/s.
double sway_speed(MotionContext const& context, State const& state);

// The ball on a surface of full grip, which ends its slip at once by an impulse at the rim; as it is on any other.
SurfaceState held_by_full_grip(MotionContext const& context, SurfaceState on_track);

// Components of the field's acceleration where the ball is, and the normal force per mass (physics.md 3.5).
double tangent_acceleration(MotionContext const& context, SurfaceState const& on_track);
double normal_force(MotionContext const& context, SurfaceState const& on_track);
// Whether the surface pushes, by more than rounding of its direction: without normal force there is no friction, and
// the ball flies, be it along the surface.
bool is_pressed(MotionContext const& context, SurfaceState const& on_track);

// Tangential acceleration = alpha a_t + beta N, rim acceleration = gamma N: rolling, with or without resistance, and
// sliding are the same law with other numbers (physics.md 4.1). It holds while each limit a_t * tangent + N *
// normal stays above zero.
struct Limit {
    double tangent = 0;
    double normal = 0;
    LegEndCause cause = LegEndCause::none;
    ModeHint hint = ModeHint::none;
};
struct ContactMode {
    Phase phase = Phase::roll;
    double alpha = 1;
    double beta = 0;
    double gamma = 0;
    double sign = 0;  // of the slip, sliding; of the way, rolling against resistance
    std::array<Limit, 3> limits{};
    int limit_count = 0;
};
ContactMode contact_mode_for(MotionContext const& context, SurfaceState const& on_track, ModeHint hint);

// Free of contact from `state` on.
LegPlan plan_flight(MotionContext const& context, State const& state, double since);
// Continues the search of a flight whose next events are known only up to `searched` seconds after its beginning.
LegPlan continue_flight(MotionContext const& context, Leg const& leg, double searched);

// On the track under the law, until something changes. `ends` says how far the track goes.
LegPlan plan_track(MotionContext const& context, SurfaceState const& on_track, ContactMode const& mode,
                   TrackEnds const& ends, double since);

// At rest, or spinning on the spot with the spin changing at spin_rate (rad/s^2) until it ends.
LegPlan plan_standing(State const& state, Contact contact, double spin_rate, double since);

// The rest of a bounce sequence on one contact in closed form, from a take-off at normal speed `hop` so low that it
// is not seen: the sum of infinitely many hops (physics.md 6.2).
LegPlan plan_settling(MotionContext const& context, SurfaceState const& on_track, double hop, double since);
// Whether that sum is exact however high the hop: where the field is constant, and all bounces stick or all slip.
bool sums_exactly(MotionContext const& context, SurfaceState const& on_track, double hop);

}  // namespace physics
