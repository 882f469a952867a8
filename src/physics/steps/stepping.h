// What the stepping methods share: the clock of counted steps, the force on a ball, legs, and events told from changes.
#pragma once

#include <algorithm>

#include "physics/world/force_field.h"
#include "physics/world/world.h"

namespace physics {

// Counted, not summed: no drift however long the run.
inline double time_of_step(World const& world, double rate, long long n) {
    return world.step_origin + static_cast<double>(n) / rate;
}

// Position and velocity after `time` without contact, exactly: a parabola, or a damped swing about the equilibrium.
struct Flight {
    Vec2 position = Vec2::Zero();
    Vec2 velocity = Vec2::Zero();
};
Flight flight_in(Field const& field, Vec2 const& position, Vec2 const& velocity, double time);

// From world.time on steps are counted anew, and nothing is remembered of steps before: neither who leaned on whom nor
// who stood still. For whenever steps begin, and when another method takes the world back.
void begin_stepping(World& world);

// Slip below this share of the speeds is rounding. Of a ball that moves `along` its surface with a rim at `rim`, m/s,
// in the rolling sense.
inline constexpr double no_slip = 1e-9;
bool slips(double along, double rim);

// How a ball is at a step's end.
struct Standing {
    State state;
    Phase phase = Phase::flight;
    Contact contact;
};

// A ball at its start: on the surface that it touches (to 1e-9 m, docs/levels.md) and is pressed upon hardest.
Standing standing_at_start(Scene const& scene, Ball const& ball);

// Ends the ball's leg at the clock's present time if it began earlier, so that the next chord spans one step only.
void open_leg(World& world, History& history, int ball, double now);
// Ends the ball's leg, begun within the step from world.time on, at `then`, and begins the next.
void write_leg(World& world, History& history, int ball, double then, Standing const& next);

// The event that a change of contact within one step amounts to, for methods that do not see it happen.
void tell_contact_change(Terrain const& terrain, Leg const& before, Leg const& after, int ball, History& history);
// Likewise the beginning and end of slip, and rest.
void tell_phase_change(Leg const& before, Leg const& after, int ball, History& history);

// Puts events [first, end) in the order of time, those of one time as they stand.
void sort_events(History& history, std::size_t first);

}  // namespace physics
