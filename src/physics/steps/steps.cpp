#include "physics/steps/steps.h"

#include <algorithm>
#include <optional>

#include "physics/plan/planned_balls.h"
#include "physics/steps/stepping.h"
#include "physics/steps/broadphase.h"
#include "physics/steps/collide.h"
#include "physics/steps/contact_island.h"
#include "physics/steps/lone_balls.h"
#include "physics/steps/sleep.h"

namespace physics {

namespace {

constexpr int steps_between_looks = 16;  // for how long the balls keep away from each other

bool is_lone(Scene const& scene, World const& world) { return scene.balls.size() == 1 && !is_stepped(world, 0); }

bool is_in_step(World const& world, std::size_t ball) { return ball < world.in_step.size() && world.in_step[ball]; }

StepContext stage_of(Steps const& method, Scene const& scene, World& world, History& history) {
    StepContext context(scene, world, history);
    context.step = 1 / method.rate;
    context.pace = context.step / method.substeps;
    context.pulled = world.forces.pull ? world.forces.pull->ball : -1;
    context.fields = {field_on(scene, world.forces, -1), field_on(scene, world.forces, context.pulled)};
    int const count = static_cast<int>(scene.balls.size());
    world.still_steps.resize(scene.balls.size(), 0);
    context.body_states.resize(scene.balls.size());
    for (int i = 0; i < count; ++i) {
        BodyState& body_state = context.body_states[i];
        body_state.index = i;
        body_state.ball = &scene.balls[i];
        body_state.field = &context.fields[i == context.pulled ? 1 : 0];
    }
    auto const [lightest, heaviest] = std::minmax_element(scene.balls.begin(), scene.balls.end(),
                                                          [](Ball const& a, Ball const& b) { return a.mass < b.mass; });
    context.mass_ratio = heaviest->mass / lightest->mass;
    context.asleep.assign(scene.balls.size(), 0);
    context.leaning.assign(scene.balls.size(), 0);
    context.ball_pairs = std::move(world.ball_pairs);
    context.fat_boxes = std::move(world.fat_boxes);
    context.island.cached_contacts = std::move(world.cached_contacts);
    context.island.swell = std::move(world.swells);
    context.island.swell.resize(scene.balls.size(), 1);
    mark_alone(context);
    return context;
}

void leave(StepContext& context, World& world) {
    world.cached_contacts = all_touches(context.island);
    world.swells = std::move(context.island.swell);
    world.ball_pairs = std::move(context.ball_pairs);
    if (!context.looked_anew) world.fat_boxes = std::move(context.fat_boxes);
}

// Who was asleep in the step before is still where he was.
void see_where_all_are(StepContext& context, double now) {
    for (BodyState& body_state : context.body_states) {
        if (context.asleep[body_state.index]) continue;
        Leg const& leg = context.world.legs[body_state.index];
        body_state.state = at(leg, now);
        body_state.contact = leg.contact;
    }
}

void move_all(StepContext& context, Substep const& substep) {
    context.told = context.history.events.size();
    if (group(context)) release_parted(context, substep.since);
    remember_departures(context, substep.end());
    for (int const i : context.free) follow(context, i, substep.end());
    move_pile(context, substep);
    if (!context.live.empty() || context.looked_anew) collide(context, substep);
}

Phase phase_of(Terrain const& terrain, BodyState const& body_state) {
    if (body_state.still) return Phase::rest;
    if (body_state.contact.feature < 0) return Phase::flight;
    Proximity const proximity =
        proximity_of(terrain, shape_of(terrain, body_state.contact.feature), body_state.state.position);
    double const across = geometry::cross(body_state.state.velocity, proximity.normal);
    return slips(across, -body_state.ball->radius * body_state.state.spin) ? Phase::slide : Phase::roll;
}

void write_step(StepContext& context, double since, double then) {
    World& world = context.world;
    for (BodyState& body_state : context.body_states)
        if (!is_stepped(world, body_state.index)) body_state.still = stands_for_ever(world.legs[body_state.index]);
    count_still(context, world);
    for (BodyState& body_state : context.body_states) {
        int const i = body_state.index;
        if (context.asleep[i] || !is_stepped(world, i)) continue;
        open_leg(world, context.history, i, since);
        Leg const before = world.legs[i];
        write_leg(world, context.history, i, then,
                  {body_state.state, phase_of(context.scene.terrain, body_state), body_state.contact});
        tell_contact_change(context.scene.terrain, before, world.legs[i], i, context.history);
        tell_phase_change(before, world.legs[i], i, context.history);
    }
}

// Balls that were in the last step learn now what has acted since it began.
void learn_of_forces(Scene const& scene, World& world, History& history, double now) {
    if (world.forces == world.step_forces) return;
    for (int i = 0; i < static_cast<int>(scene.balls.size()); ++i) {
        bool const is_other_field = is_other(field_on(scene, world.step_forces, i), field_on(scene, world.forces, i));
        if (is_in_step(world, i) && !is_stepped(world, i) && is_other_field)
            change_field(scene, world, history, i, now);
    }
    world.step_forces = world.forces;
    world.clear_until = -never;
}

// From `since`, where all balls are, to `then`, where those that have others near will be.
void take_step(StepContext& context, Steps const& method, double since, double then) {
    World& world = context.world;
    world.in_step.assign(context.body_states.size(), 0);
    if (all_asleep(context.scene, world)) return;
    see_where_all_are(context, since);
    put_to_sleep(context, context.pace);
    find_neighbours(context, context.step);
    if (group(context)) release_parted(context, since);
    if (!context.awake.empty())
        for (int i = 0; i < method.substeps; ++i) move_all(context, {since + i * context.pace, context.pace});
    for (std::size_t i = 0; i < context.alone.size(); ++i) world.in_step[i] = !context.alone[i];
    write_step(context, since, then);
    bool const was_clear = since - world.clear_until < context.step;
    if (was_clear || world.steps_taken % steps_between_looks == 0)
        world.clear_until = since + clear_span(context, since);
}

// The first step after those taken that is not before `time`, s.
long long next_step(World const& world, double rate, double time) {
    long long step = world.steps_taken + 1;
    // Counted on from just below, as the quotient is rounded.
    if (time > time_of_step(world, rate, step))
        step = std::max(step, static_cast<long long>((time - world.step_origin) * rate) - 1);
    while (time_of_step(world, rate, step) < time) ++step;
    return step;
}

void follow_all(Scene const& scene, World& world, History& history, double until) {
    for (int i = 0; i < static_cast<int>(scene.balls.size()); ++i)
        if (!is_in_step(world, i) && !is_stepped(world, i)) follow_plan(scene, world, history, i, until);
}

// Events of balls in the step, told when their time has come.
void tell_ahead(World& world, History& history) {
    for (Event const& event : world.ahead) history.events.push_back(event);
    world.ahead.clear();
}

void keep_ahead(World& world, History& history) {
    while (!history.events.empty() && history.events.back().time > world.time) {
        world.ahead.push_back(history.events.back());
        history.events.pop_back();
    }
    std::reverse(world.ahead.begin(), world.ahead.end());
}

}  // namespace

void begin_with(Steps const&, Scene const& scene, World& world, History& history) {
    world.legs.resize(scene.balls.size());
    world.plans.assign(scene.balls.size(), {});
    history.legs.assign(scene.balls.size(), {});
    for (int i = 0; i < static_cast<int>(scene.balls.size()); ++i)
        set_out(scene, world, history, i, scene.balls[i].start, no_contact, 0);
}

void advance_with(Steps const& method, Scene const& scene, World& world, double until, History& history) {
    if (is_lone(scene, world)) return advance_alone(scene, world, history, until);
    std::size_t const first_event = history.events.size();
    tell_ahead(world, history);
    std::optional<StepContext> context;
    while (world.time < until) {
        double then = time_of_step(world, method.rate, world.steps_taken);
        if (world.time >= then) {
            double const since = then;
            learn_of_forces(scene, world, history, since);
            bool const looks = since >= world.clear_until;
            if (looks && !context) context.emplace(stage_of(method, scene, world, history));
            // Where nobody was near another until now, the next look comes first.
            if (looks && since - world.clear_until < context->step)
                world.clear_until = since + clear_span(*context, since);
            world.steps_taken = next_step(world, method.rate, std::min(world.clear_until, until));
            then = time_of_step(world, method.rate, world.steps_taken);
            if (since >= world.clear_until) take_step(*context, method, since, then);
        }
        double const to = std::min(then, until);
        follow_all(scene, world, history, to);
        world.time = to;
    }
    if (context) leave(*context, world);
    sort_events(history, first_event);
    keep_ahead(world, history);
}

void force_with(Steps const&, Scene const& scene, World& world, Forces const& before, History& history) {
    if (is_lone(scene, world)) return force_alone(scene, world, history, before);
    for (int i = 0; i < static_cast<int>(scene.balls.size()); ++i) {
        if (is_in_step(world, i) || is_stepped(world, i)) continue;
        if (is_other(field_on(scene, before, i), field_on(scene, world.forces, i)))
            change_field(scene, world, history, i, world.time);
    }
}

}  // namespace physics
