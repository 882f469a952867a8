#include "physics/steps_sleep.h"

#include <algorithm>
#include <cmath>

namespace physics {

namespace {

constexpr int steps_to_sleep = 4;   // steps on end without motion after which a ball is left standing
constexpr double stirring = 1e-2;   // m/s: what leans on a faster ball is woken
constexpr double unbearable = 0.1;  // share of a sleeper's weight by which what presses on it may change

double change_of(Neighbours const& pair) {
    return std::abs(pair.impulse.normal - pair.borne.normal) + std::abs(pair.impulse.tangent - pair.borne.tangent);
}

void mark_asleep(Stage& stage, World const& world) {
    for (std::size_t i = 0; i < stage.asleep.size(); ++i) stage.asleep[i] = world.still_steps[i] >= steps_to_sleep;
}

void wake_leaning(Stage& stage, World& world, double pace) {
    for (Neighbours const& pair : stage.neighbours) {
        if (!pair.leaning || stage.asleep[pair.first] == stage.asleep[pair.second]) continue;
        int const sleeper = stage.asleep[pair.first] ? pair.first : pair.second;
        Traveller const& other = stage.travellers[stage.asleep[pair.first] ? pair.second : pair.first];
        double const weight = stage.pile.swell[sleeper] * stage.travellers[sleeper].ball->mass *
                              geometry::length(stage.travellers[sleeper].field->gravity) * pace;
        bool const moves = geometry::length(other.state.velocity) > stirring;
        if (moves || change_of(pair) > unbearable * weight) world.still_steps[sleeper] = 0;
    }
}

}  // namespace

bool all_asleep(Scene const& scene, World const& world) {
    return world.still_steps.size() == scene.balls.size() &&
           std::all_of(world.still_steps.begin(), world.still_steps.end(), [](int n) { return n >= steps_to_sleep; });
}

void put_to_sleep(Stage& stage, double pace) {
    World& world = stage.world;
    std::vector<char> const before = stage.asleep;
    mark_asleep(stage, world);
    wake_leaning(stage, world, pace);
    mark_asleep(stage, world);
    if (stage.asleep != before) stage.regroup = true;
}

void count_still(Stage& stage, World& world) {
    bool any = false;
    for (Traveller& traveller : stage.travellers) {
        int const i = traveller.index;
        if (stage.asleep[i]) continue;
        int& still = world.still_steps[i];
        still = traveller.still ? still + 1 : 0;
        if (still < steps_to_sleep) continue;
        traveller.state.velocity = Vec2::Zero();
        traveller.state.spin = 0;
        any = true;
    }
    if (!any) return;
    auto const falls_asleep = [&](int i) { return !stage.asleep[i] && world.still_steps[i] >= steps_to_sleep; };
    for (Neighbours& pair : stage.neighbours)
        if (falls_asleep(pair.first) || falls_asleep(pair.second)) pair.borne = pair.impulse;
}

}  // namespace physics
