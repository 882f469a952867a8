#include "physics/method.h"

#include <cmath>

#include "physics/world/sensors.h"
#include "physics/steps/stepping.h"

namespace physics {

char const* name_of(Method const& method) {
    struct Names {
        char const* operator()(Article const&) const { return "article"; }
        char const* operator()(Euler const&) const { return "euler"; }
        char const* operator()(Steps const&) const { return "steps"; }
        char const* operator()(Exact const&) const { return "exact"; }
    };
    return std::visit(Names{}, method);
}

namespace {

// A method of steps alone knows nothing of the way ahead: every ball is on a straight leg until the first step.
template <typename OfStepsAlone>
void begin_with(OfStepsAlone const&, Scene const& scene, World& world, History& history) {
    for (Ball const& ball : scene.balls) {
        Standing const standing = standing_at_start(scene, ball);
        Leg leg;
        leg.phase = standing.phase;
        leg.contact = standing.contact;
        leg.motion = Straight{ball.start, ball.start.velocity, ball.start.spin};
        world.legs.push_back(leg);
        history.legs.push_back({leg});
    }
}

// A step reads the forces when it begins.
template <typename OfStepsAlone>
void force_with(OfStepsAlone const&, Scene const&, World&, Forces const&, History&) {}

}  // namespace

World world_at_start(Method const& method, Scene const& scene, History& history) {
    World world;
    history = {};
    std::visit([&](auto const& m) { begin_with(m, scene, world, history); }, method);
    world.noticed = nothing_noticed(scene);
    sense(scene, world, -never, 0, history);
    return world;
}

std::optional<Fault> advance(Method const& method, Scene const& scene, World& world, double until, History& history) {
    if (!std::isfinite(until)) return Fault{"the time to advance to is not finite"};
    double const from = world.time;
    if (until <= from) return std::nullopt;
    std::visit([&](auto const& m) { advance_with(m, scene, world, until, history); }, method);
    if (!scene.sensors.empty()) sense(scene, world, from, world.time, history);
    return std::nullopt;
}

std::optional<Fault> apply(Method const& method, Scene const& scene, World& world, Forces const& forces,
                           History& history) {
    if (!std::isfinite(forces.tilt)) return Fault{"the tilt is not finite"};
    if (forces.pull && !geometry::is_finite(forces.pull->target)) return Fault{"the target of the pull is not finite"};
    if (forces.pull && (forces.pull->ball < 0 || forces.pull->ball >= static_cast<int>(scene.balls.size())))
        return Fault{"there is no ball " + std::to_string(forces.pull->ball)};
    // What stands may move now: all of it under another gravity, else what is pulled or no longer is.
    if (forces.tilt != world.forces.tilt) world.still_steps.clear();
    for (auto const& pull : {world.forces.pull, forces.pull})
        if (pull && pull->ball < static_cast<int>(world.still_steps.size())) world.still_steps[pull->ball] = 0;
    Forces const before = world.forces;
    world.forces = forces;
    std::visit([&](auto const& m) { force_with(m, scene, world, before, history); }, method);
    return std::nullopt;
}

}  // namespace physics
