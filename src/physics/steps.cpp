#include "physics/steps.h"

#include <algorithm>

#include "physics/steps_pairs.h"
#include "physics/steps_pile.h"
#include "physics/steps_stage.h"

namespace physics {

namespace {

constexpr int steps_to_sleep = 4;  // steps on end without motion after which a ball is left standing

Stage stage_of(Scene const& scene, World& world) {
    Stage stage(scene);
    int const count = static_cast<int>(scene.balls.size());
    world.still_steps.resize(scene.balls.size(), 0);
    stage.travellers.resize(scene.balls.size());
    for (int i = 0; i < count; ++i) {
        Traveller& traveller = stage.travellers[i];
        traveller.index = i;
        traveller.ball = &scene.balls[i];
        traveller.field = field_on(scene, world.forces, i);
        traveller.state = at(world.legs[i], world.time);
        traveller.contact = world.legs[i].contact;
    }
    stage.leaning.assign(scene.balls.size(), 0);
    stage.asleep.assign(scene.balls.size(), 0);
    recall_touches(stage, world.touches);
    return stage;
}

// Balls that stand are left standing until something near them moves.
bool put_to_sleep(Stage& stage, World const& world) {
    bool all = true;
    for (std::size_t i = 0; i < stage.asleep.size(); ++i) {
        stage.asleep[i] = world.still_steps[i] >= steps_to_sleep;
        all = all && stage.asleep[i];
    }
    if (!all) wake_neighbours(stage);
    return all;
}

void move_all(Stage& stage, Substep const& substep) {
    remember_departures(stage);
    bool const any_lean = mark_leaning(stage);
    for (Traveller& traveller : stage.travellers)
        if (!stage.asleep[traveller.index] && !stage.leaning[traveller.index] && !stage.alone[traveller.index])
            travel(substep, traveller, 0);
    if (any_lean) move_pile(stage, substep);
    if (!stage.encounters.empty()) collide(stage, substep);
}

// Free balls and balls on one surface move by closed forms, which need no substeps.
bool move_alone(Stage& stage, Substep const& step) {
    bool all = true;
    for (Traveller& traveller : stage.travellers) {
        bool const alone = stage.alone[traveller.index] != 0;
        all = all && (alone || stage.asleep[traveller.index]);
        if (alone && !stage.asleep[traveller.index]) travel(step, traveller, 0);
    }
    return all;
}

void write_step(Stage& stage, World& world, double then, History& history) {
    for (Traveller& traveller : stage.travellers) {
        int const i = traveller.index;
        if (stage.asleep[i]) continue;
        open_leg(world, history, i, world.time);
        Leg const before = world.legs[i];
        bool const stood = traveller.still;
        world.still_steps[i] = stood ? world.still_steps[i] + 1 : 0;
        if (world.still_steps[i] >= steps_to_sleep) {
            traveller.state.velocity = Vec2::Zero();
            traveller.state.spin = 0;
        }
        write_leg(world, history, i, then, {traveller.state, phase_of(traveller), traveller.contact});
        if (stage.leaning[i]) tell_contact_change(stage.scene.terrain, before, world.legs[i], i, history);
        tell_phase_change(before, world.legs[i], i, history);
    }
}

}  // namespace

void advance_with(Steps const& method, Scene const& scene, World& world, double until, History& history) {
    std::size_t const first_event = history.events.size();
    Stage stage = stage_of(scene, world);
    double const step = 1 / method.rate, pace = step / method.substeps;
    while (world.time < until) {
        double const then = time_of_step(world, method.rate, world.steps_taken + 1);
        if (!put_to_sleep(stage, world)) {
            find_encounters(stage, step);
            if (!move_alone(stage, {scene.terrain, world.time, step, pace, history.events}))
                for (int i = 0; i < method.substeps; ++i)
                    move_all(stage, {scene.terrain, world.time + i * pace, pace, pace, history.events});
            write_step(stage, world, then, history);
        }
        ++world.steps_taken;
        world.time = then;
    }
    world.touches = touches_of(stage);
    sort_events(history, first_event);
}

}  // namespace physics
