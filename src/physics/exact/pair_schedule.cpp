#include "physics/exact/pair_schedule.h"

#include <algorithm>
#include <cmath>

#include "physics/plan/leg_plan.h"

namespace physics {

namespace {

// Speeds of approach below this share of the speeds are rounding.
constexpr double speed_rounding = 1e-12;

bool is_among(std::span<int const> balls, int ball) {
    return std::find(balls.begin(), balls.end(), ball) != balls.end();
}

void expect(BallPlan& plan, double time, int ball) {
    if (!(time < plan.hit_time)) return;
    plan.hit_time = time;
    plan.hit_ball = ball;
}

// A meeting later than what both expect need not be known: one of them will be another ball's by then.
void schedule_hit(Scene const& scene, World& world, int i, int j) {
    BallPlan& mine = world.plans[i];
    BallPlan& other = world.plans[j];
    double const expected = std::max(mine.hit_time, other.hit_time);
    double const until = std::min({world.legs[i].until, world.legs[j].until, expected});
    double const reach = scene.balls[i].radius + scene.balls[j].radius;
    TimeOfImpact const met = time_of_impact(world.legs[i], world.legs[j], reach, world.time, until);
    if (met.meets) {
        expect(mine, met.time, j);
        expect(other, met.time, i);
    } else if (met.time < until) {
        // What has not been searched to its end is looked at again where the search stopped.
        expect(mine, met.time, -1);
    }
}

}  // namespace

void schedule_hits(Scene const& scene, World& world, std::span<int const> touched) {
    int const count = static_cast<int>(scene.balls.size());
    if (count == 1) return;
    std::vector<bool> looks(scene.balls.size());
    for (int i = 0; i < count; ++i) looks[i] = is_among(touched, i) || is_among(touched, world.plans[i].hit_ball);
    for (int i = 0; i < count; ++i) {
        if (!looks[i]) continue;
        world.plans[i].hit_time = never;
        world.plans[i].hit_ball = -1;
    }
    for (int i = 0; i < count; ++i) {
        if (!looks[i]) continue;
        for (int j = 0; j < count; ++j)
            if (j > i || !looks[j]) schedule_hit(scene, world, i, j);
    }
}

namespace {

bool hits_now(World const& world, int i) {
    return world.plans[i].hit_ball >= 0 && world.plans[i].hit_time <= world.time + moment;
}

bool have_met(World const& world, int a, int b) {
    return (hits_now(world, a) && world.plans[a].hit_ball == b) || (hits_now(world, b) && world.plans[b].hit_ball == a);
}

// Slower than the lowest hop they do not meet any more: they press on each other.
bool closes(Scene const& scene, int a, State const& at_a, int b, State const& at_b) {
    double const speeds = geometry::length(at_a.velocity) + geometry::length(at_b.velocity);
    double const radius = std::min(scene.balls[a].radius, scene.balls[b].radius);
    double const least = std::sqrt(2 * scene.gravity * lowest_hop * radius);
    return closing_speed(at_a, at_b) > std::max(least, speed_rounding * speeds);
}

}  // namespace

std::vector<Pair> closing_pairs(Scene const& scene, World const& world, std::vector<State> const& states) {
    std::vector<Pair> pairs;
    int const count = static_cast<int>(scene.balls.size());
    for (int a = 0; a < count; ++a)
        for (int b = a + 1; b < count; ++b) {
            if (!hits_now(world, a) && !hits_now(world, b)) continue;
            double const reach = scene.balls[a].radius + scene.balls[b].radius;
            double const gap = geometry::length(states[b].position - states[a].position) - reach;
            bool const meet = have_met(world, a, b) || gap <= touch_reach;
            if (meet && closes(scene, a, states[a], b, states[b])) pairs.push_back({a, b});
        }
    return pairs;
}

}  // namespace physics
