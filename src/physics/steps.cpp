#include "physics/steps.h"

#include <algorithm>
#include <optional>

#include "physics/exact.h"
#include "physics/stepping.h"
#include "physics/steps_pairs.h"
#include "physics/steps_pile.h"
#include "physics/steps_plan.h"
#include "physics/steps_sleep.h"

namespace physics {

namespace {

constexpr int steps_between_looks = 16;  // for how long the balls keep away from each other

bool is_lone(Scene const& scene, World const& world) { return scene.balls.size() == 1 && !is_stepped(world, 0); }

bool is_in_step(World const& world, std::size_t ball) { return ball < world.in_step.size() && world.in_step[ball]; }

bool is_other(Field const& a, Field const& b) {
    return a.gravity != b.gravity || a.pulled != b.pulled || a.target != b.target;
}

Stage stage_of(Steps const& method, Scene const& scene, World& world, History& history) {
    Stage stage(scene, world, history);
    stage.step = 1 / method.rate;
    stage.pace = stage.step / method.substeps;
    stage.pulled = world.forces.pull ? world.forces.pull->ball : -1;
    stage.fields = {field_on(scene, world.forces, -1), field_on(scene, world.forces, stage.pulled)};
    int const count = static_cast<int>(scene.balls.size());
    world.still_steps.resize(scene.balls.size(), 0);
    stage.travellers.resize(scene.balls.size());
    for (int i = 0; i < count; ++i) {
        Traveller& traveller = stage.travellers[i];
        traveller.index = i;
        traveller.ball = &scene.balls[i];
        traveller.field = &stage.fields[i == stage.pulled ? 1 : 0];
    }
    stage.asleep.assign(scene.balls.size(), 0);
    stage.leaning.assign(scene.balls.size(), 0);
    stage.neighbours = std::move(world.neighbours);
    stage.reaches = std::move(world.reaches);
    stage.pile.touches = std::move(world.touches);
    stage.pile.swell = std::move(world.swells);
    stage.pile.swell.resize(scene.balls.size(), 1);
    mark_alone(stage);
    return stage;
}

void leave(Stage& stage, World& world) {
    world.touches = all_touches(stage.pile);
    world.swells = std::move(stage.pile.swell);
    world.neighbours = std::move(stage.neighbours);
    if (!stage.looked_anew) world.reaches = std::move(stage.reaches);
}

void see_where_all_are(Stage& stage, double now) {
    for (Traveller& traveller : stage.travellers) {
        Leg const& leg = stage.world.legs[traveller.index];
        traveller.state = at(leg, now);
        traveller.contact = leg.contact;
    }
}

void move_all(Stage& stage, Substep const& substep) {
    if (group(stage)) release_parted(stage, substep.since);
    remember_departures(stage);
    for (int const i : stage.free) follow(stage, i, substep.end());
    move_pile(stage, substep);
    if (!stage.live.empty() || stage.looked_anew) collide(stage, substep);
}

Phase phase_of(Terrain const& terrain, Traveller const& traveller) {
    if (traveller.still) return Phase::rest;
    if (traveller.contact.feature < 0) return Phase::flight;
    Sight const sight = sight_of(terrain, shape_of(terrain, traveller.contact.feature), traveller.state.position);
    double const across = geometry::wedge(traveller.state.velocity, sight.normal);
    return slips(across, -traveller.ball->radius * traveller.state.spin) ? Phase::slide : Phase::roll;
}

void write_step(Stage& stage, double since, double then) {
    World& world = stage.world;
    for (Traveller& traveller : stage.travellers)
        if (!is_stepped(world, traveller.index)) traveller.still = stands_for_ever(world.legs[traveller.index]);
    count_still(stage, world);
    for (Traveller& traveller : stage.travellers) {
        int const i = traveller.index;
        if (stage.asleep[i] || !is_stepped(world, i)) continue;
        open_leg(world, stage.history, i, since);
        Leg const before = world.legs[i];
        write_leg(world, stage.history, i, then,
                  {traveller.state, phase_of(stage.scene.terrain, traveller), traveller.contact});
        tell_contact_change(stage.scene.terrain, before, world.legs[i], i, stage.history);
        tell_phase_change(before, world.legs[i], i, stage.history);
    }
}

// Balls that were in the last step learn now what has acted since it began.
void learn_of_forces(Scene const& scene, World& world, History& history, double now) {
    if (world.forces == world.step_forces) return;
    for (int i = 0; i < static_cast<int>(scene.balls.size()); ++i) {
        bool const is_other_field = is_other(field_on(scene, world.step_forces, i), field_on(scene, world.forces, i));
        if (is_in_step(world, i) && !is_stepped(world, i) && is_other_field) change_field(scene, world, history, i, now);
    }
    world.step_forces = world.forces;
    world.clear_until = -never;
}

// From `since`, where all balls are, to `then`, where those that have others near will be.
void take_step(Stage& stage, Steps const& method, double since, double then) {
    World& world = stage.world;
    world.in_step.assign(stage.travellers.size(), 0);
    if (all_asleep(stage.scene, world)) return;
    see_where_all_are(stage, since);
    put_to_sleep(stage, stage.pace);
    find_neighbours(stage, stage.step);
    if (group(stage)) release_parted(stage, since);
    if (!stage.awake.empty())
        for (int i = 0; i < method.substeps; ++i) move_all(stage, {since + i * stage.pace, stage.pace});
    for (std::size_t i = 0; i < stage.alone.size(); ++i) world.in_step[i] = !stage.alone[i];
    write_step(stage, since, then);
    bool const was_clear = since - world.clear_until < stage.step;
    if (was_clear || world.steps_taken % steps_between_looks == 0) world.clear_until = since + clear_span(stage);
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
    world.outlooks.assign(scene.balls.size(), {});
    history.legs.assign(scene.balls.size(), {});
    for (int i = 0; i < static_cast<int>(scene.balls.size()); ++i)
        set_out(scene, world, history, i, scene.balls[i].start, no_contact, 0);
}

void advance_with(Steps const& method, Scene const& scene, World& world, double until, History& history) {
    if (is_lone(scene, world)) return advance_with(Exact{}, scene, world, until, history);
    std::size_t const first_event = history.events.size();
    tell_ahead(world, history);
    std::optional<Stage> stage;
    while (world.time < until) {
        double then = time_of_step(world, method.rate, world.steps_taken);
        if (world.time >= then) {
            double const since = then;
            learn_of_forces(scene, world, history, since);
            do {
                then = time_of_step(world, method.rate, ++world.steps_taken);
            } while (then < world.clear_until && then < until);
            if (since >= world.clear_until) {
                if (!stage) stage.emplace(stage_of(method, scene, world, history));
                take_step(*stage, method, since, then);
            }
        }
        double const to = std::min(then, until);
        follow_all(scene, world, history, to);
        world.time = to;
    }
    if (stage) leave(*stage, world);
    sort_events(history, first_event);
    keep_ahead(world, history);
}

void force_with(Steps const&, Scene const& scene, World& world, Forces const& before, History& history) {
    if (is_lone(scene, world)) return force_with(Exact{}, scene, world, before, history);
    for (int i = 0; i < static_cast<int>(scene.balls.size()); ++i) {
        if (is_in_step(world, i) || is_stepped(world, i)) continue;
        if (is_other(field_on(scene, before, i), field_on(scene, world.forces, i)))
            change_field(scene, world, history, i, world.time);
    }
}

}  // namespace physics
