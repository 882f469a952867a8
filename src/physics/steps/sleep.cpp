#include "physics/steps/sleep.h"

#include <algorithm>
#include <cmath>

namespace physics {

namespace {

constexpr int steps_to_sleep = 4;    // steps on end without motion after which a ball is left standing
constexpr double wake_speed = 1e-2;  // m/s: what leans on a faster ball is woken
constexpr double unbearable = 0.1;   // share of a sleeper's weight by which what presses on it may change

double change_of(BallPair const& pair) {
    return std::abs(pair.impulse.normal - pair.borne.normal) + std::abs(pair.impulse.tangent - pair.borne.tangent);
}

void mark_asleep(StepContext& context, World const& world) {
    for (std::size_t i = 0; i < context.asleep.size(); ++i) context.asleep[i] = world.still_steps[i] >= steps_to_sleep;
}

void wake_leaning(StepContext& context, World& world, double pace) {
    for (BallPair const& pair : context.ball_pairs) {
        if (!pair.leaning || context.asleep[pair.first] == context.asleep[pair.second]) continue;
        int const sleeper = context.asleep[pair.first] ? pair.first : pair.second;
        BodyState const& other = context.body_states[context.asleep[pair.first] ? pair.second : pair.first];
        double const weight = context.island.swell[sleeper] * context.body_states[sleeper].ball->mass *
                              geometry::length(context.body_states[sleeper].field->gravity) * pace;
        bool const moves = geometry::length(other.state.velocity) > wake_speed;
        if (moves || change_of(pair) > unbearable * weight) world.still_steps[sleeper] = 0;
    }
}

}  // namespace

bool all_asleep(Scene const& scene, World const& world) {
    return world.still_steps.size() == scene.balls.size() &&
           std::all_of(world.still_steps.begin(), world.still_steps.end(), [](int n) { return n >= steps_to_sleep; });
}

void put_to_sleep(StepContext& context, double pace) {
    World& world = context.world;
    std::vector<char> const before = context.asleep;
    mark_asleep(context, world);
    wake_leaning(context, world, pace);
    mark_asleep(context, world);
    if (context.asleep != before) context.regroup = true;
}

void count_still(StepContext& context, World& world) {
    bool any = false;
    for (BodyState& body_state : context.body_states) {
        int const i = body_state.index;
        if (context.asleep[i]) continue;
        int& still = world.still_steps[i];
        still = body_state.still ? still + 1 : 0;
        if (still < steps_to_sleep) continue;
        body_state.state.velocity = Vec2::Zero();
        body_state.state.spin = 0;
        any = true;
    }
    if (!any) return;
    auto const falls_asleep = [&](int i) { return !context.asleep[i] && world.still_steps[i] >= steps_to_sleep; };
    for (BallPair& pair : context.ball_pairs)
        if (falls_asleep(pair.first) || falls_asleep(pair.second)) pair.borne = pair.impulse;
}

}  // namespace physics
