#include "bounds.h"

namespace laws {

namespace {

struct Row {
    Law law;
    physics::Method method;
    double tolerance;
};

// `exact` is right to the rounding of doubles, which the measures of some laws multiply a little.
// `steps` leaves a ball that no other is near on the same plan, and is held to the same; what it steps are piles.
// `article` is bound where its ball, all mass at the hub, obeys the same law; to first order in its step of 1/240 s.
Row const table[] = {
    {Law::flight, physics::Exact{}, 1e-12},
    {Law::roll_on_slope, physics::Exact{}, 1e-12},
    {Law::slide_on_slope, physics::Exact{}, 1e-12},
    {Law::slip_to_roll, physics::Exact{}, 1e-12},
    {Law::spin_down, physics::Exact{}, 1e-12},
    {Law::rolling_resistance, physics::Exact{}, 1e-12},
    {Law::swing_in_valley, physics::Exact{}, 1e-12},
    {Law::energy_in_valley, physics::Exact{}, 1e-12},
    {Law::lift_off, physics::Exact{}, 1e-9},
    {Law::loop, physics::Exact{}, 1e-9},
    {Law::bend, physics::Exact{}, 1e-12},
    {Law::hill, physics::Exact{}, 1e-12},
    {Law::flat_joints, physics::Exact{}, 1e-12},
    {Law::corner, physics::Exact{}, 1e-12},
    {Law::vertex, physics::Exact{}, 1e-11},
    {Law::bounce, physics::Exact{}, 1e-12},
    {Law::impact_energy, physics::Exact{}, 1e-12},
    {Law::pair_momentum, physics::Exact{}, 1e-12},
    {Law::drag_in_air, physics::Exact{}, 1e-12},
    {Law::drag_on_ground, physics::Exact{}, 3e-12},
    {Law::groove, physics::Exact{}, 1e-11},
    {Law::path_of_centre, physics::Exact{}, 1e-12},
    {Law::rest_time, physics::Exact{}, 1e-12},
    {Law::no_escape, physics::Exact{}, 1e-9},
    {Law::rest, physics::Exact{}, 0},
    {Law::piles, physics::Exact{}, 1e-2},
    {Law::far_away, physics::Exact{}, 1e-9},
    {Law::lawful_input, physics::Exact{}, 0},
    {Law::late_frame, physics::Exact{}, 0},
    {Law::hour, physics::Exact{}, 10},
    {Law::simultaneous, physics::Exact{}, 1e-12},
    {Law::flight, physics::Steps{}, 1e-12},
    {Law::roll_on_slope, physics::Steps{}, 1e-12},
    {Law::slide_on_slope, physics::Steps{}, 1e-12},
    {Law::slip_to_roll, physics::Steps{}, 1e-12},
    {Law::spin_down, physics::Steps{}, 1e-12},
    {Law::rolling_resistance, physics::Steps{}, 1e-12},
    {Law::swing_in_valley, physics::Steps{}, 1e-12},
    {Law::energy_in_valley, physics::Steps{}, 1e-12},
    {Law::lift_off, physics::Steps{}, 1e-9},
    {Law::loop, physics::Steps{}, 1e-9},
    {Law::bend, physics::Steps{}, 1e-12},
    {Law::hill, physics::Steps{}, 1e-12},
    {Law::flat_joints, physics::Steps{}, 1e-12},
    {Law::corner, physics::Steps{}, 1e-12},
    {Law::vertex, physics::Steps{}, 1e-11},
    {Law::bounce, physics::Steps{}, 1e-12},
    {Law::impact_energy, physics::Steps{}, 1e-12},
    {Law::pair_momentum, physics::Steps{}, 1e-12},
    {Law::drag_in_air, physics::Steps{}, 1e-12},
    {Law::drag_on_ground, physics::Steps{}, 3e-12},
    {Law::groove, physics::Steps{}, 1e-11},
    {Law::path_of_centre, physics::Steps{}, 1e-12},
    {Law::rest_time, physics::Steps{}, 1e-12},
    {Law::no_escape, physics::Steps{}, 1e-9},
    {Law::rest, physics::Steps{}, 0},
    {Law::piles, physics::Steps{}, 1e-2},
    {Law::far_away, physics::Steps{}, 1e-9},
    {Law::lawful_input, physics::Steps{}, 0},
    {Law::late_frame, physics::Steps{}, 0},
    {Law::hour, physics::Steps{}, 10},
    {Law::simultaneous, physics::Steps{}, 1e-12},
    {Law::path_of_centre, physics::Article{}, 1e-3},
    {Law::flat_joints, physics::Article{}, 1e-9},
    {Law::hill, physics::Article{}, 1e-2},
    {Law::drag_in_air, physics::Article{}, 1e-11},
    {Law::rest, physics::Article{}, 1e-12},
    {Law::far_away, physics::Article{}, 1e-6},
    {Law::lawful_input, physics::Article{}, 0},
    {Law::late_frame, physics::Article{}, 0},
    {Law::hour, physics::Article{}, 0},
};

}  // namespace

std::vector<Bound> bounds_of(Law law) {
    std::vector<Bound> bounds;
    for (Row const& row : table)
        if (row.law == law) bounds.push_back({row.method, row.tolerance});
    return bounds;
}

}  // namespace laws
