#include "physics/exact/handover.h"

#include <algorithm>

#include "physics/exact/exact.h"
#include "physics/plan/planned_balls.h"
#include "physics/steps/stepping.h"
#include "physics/steps/steps.h"
#include "physics/steps/lone_balls.h"

namespace physics {

namespace {

void tell(EventKind kind, std::vector<int> const& island, World const& world, History& history) {
    int const first = island.front();
    if (history.islands.empty() || history.islands.back() != island) history.islands.push_back(island);
    history.events.push_back({world.time, kind, first, at(world.legs[first], world.time), world.legs[first].contact,
                              static_cast<int>(history.islands.size()) - 1});
}

bool are_near(Scene const& scene, World const& world, int a, int b) {
    double const one = scene.balls[a].radius, other = scene.balls[b].radius;
    Vec2 const way = at(world.legs[b], world.time).position - at(world.legs[a], world.time).position;
    return geometry::length(way) - one - other < takeover_gap * std::min(one, other);
}

// The ball and those near it, and those near these, in order.
std::vector<int> island_of(Scene const& scene, World const& world, int ball) {
    std::vector<int> island{ball};
    std::vector<char> known(scene.balls.size(), 0);
    known[ball] = 1;
    for (std::size_t k = 0; k < island.size(); ++k)
        for (int other = 0; other < static_cast<int>(scene.balls.size()); ++other)
            if (!known[other] && are_near(scene, world, island[k], other)) {
                known[other] = 1;
                island.push_back(other);
            }
    std::sort(island.begin(), island.end());
    return island;
}

}  // namespace

void hand_over(Scene const& scene, World& world, int ball, History& history) {
    world.handed_over = true;
    world.island = island_of(scene, world, ball);
    world.quiet_until = -never;
    world.handover_time = world.time;
    begin_stepping(world);
    tell(EventKind::handover, world.island, world, history);
}

namespace {

bool is_at_step(World const& world) { return world.time == time_of_step(world, handover_rate, world.steps_taken); }

// Balls that have come to lean on others since, with those near them, are handed over as well.
void hand_over_more(Scene const& scene, World& world, History& history) {
    auto const is_handed_over = [&](int i) { return std::binary_search(world.island.begin(), world.island.end(), i); };
    for (int i = 0; i < static_cast<int>(scene.balls.size()); ++i) {
        if (!is_stepped(world, i) || is_handed_over(i)) continue;
        std::vector<int> more = island_of(scene, world, i);
        std::erase_if(more, is_handed_over);
        tell(EventKind::handover, more, world, history);
        world.island.insert(world.island.end(), more.begin(), more.end());
        std::sort(world.island.begin(), world.island.end());
    }
}

}  // namespace

void step_handed_over(Scene const& scene, World& world, double until, History& history) {
    double const begun = time_of_step(world, handover_rate, world.steps_taken);
    double const next = world.time < begun ? begun : time_of_step(world, handover_rate, world.steps_taken + 1);
    advance_with(Steps{handover_rate}, scene, world, std::min(next, until), history);
    if (is_at_step(world)) hand_over_more(scene, world, history);
}

bool is_apart(Scene const& scene, World const& world) {
    if (!is_at_step(world) || world.time - world.handover_time < shortest_handover) return false;
    for (int a = 0; a < static_cast<int>(scene.balls.size()); ++a)
        for (int b = a + 1; b < static_cast<int>(scene.balls.size()); ++b)
            if (are_near(scene, world, a, b)) return false;
    return true;
}

void take_back(Scene const& scene, World& world, History& history) {
    world.handed_over = false;
    tell(EventKind::takeover, world.island, world, history);
    for (int i = 0; i < static_cast<int>(scene.balls.size()); ++i) {
        if (is_stepped(world, i))
            release(scene, world, history, i, world.time);
        else if (world.forces != world.step_forces && world.in_step[i])
            change_field(scene, world, history, i, world.time);
    }
    begin_stepping(world);
}

}  // namespace physics
