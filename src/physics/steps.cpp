#include "physics/steps.h"

#include <algorithm>

#include "physics/steps_pairs.h"
#include "physics/steps_pile.h"
#include "physics/steps_sleep.h"

namespace physics {

namespace {

Stage stage_of(Scene const& scene, World& world) {
    Stage stage(scene);
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
        traveller.state = at(world.legs[i], world.time);
        traveller.contact = world.legs[i].contact;
    }
    stage.asleep.assign(scene.balls.size(), 0);
    stage.leaning.assign(scene.balls.size(), 0);
    stage.neighbours = std::move(world.neighbours);
    stage.reaches = std::move(world.reaches);
    stage.pile.touches = std::move(world.touches);
    mark_alone(stage);
    return stage;
}

void leave(Stage& stage, World& world) {
    world.touches = all_touches(stage.pile);
    world.neighbours = std::move(stage.neighbours);
    if (!stage.looked_anew) world.reaches = std::move(stage.reaches);
}

void move_all(Stage& stage, Substep const& substep) {
    group(stage);
    remember_departures(stage);
    for (int const i : stage.free) travel(substep, stage.travellers[i], 0);
    move_pile(stage, substep);
    if (!stage.live.empty()) collide(stage, substep);
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

// What was told of free balls within the step, those of one ball on end, in order of time.
std::vector<Event> corners_of_step(Stage const& stage, World const& world, double then, History const& history,
                                   std::size_t first_event) {
    std::vector<Event> corners;
    for (std::size_t i = first_event; i < history.events.size(); ++i) {
        Event const& event = history.events[i];
        bool const within = event.time > world.time && event.time < then;
        if (within && !stage.leaning[event.ball] && !stage.asleep[event.ball]) corners.push_back(event);
    }
    std::stable_sort(corners.begin(), corners.end(), [](Event const& a, Event const& b) {
        return a.ball != b.ball ? a.ball < b.ball : a.time < b.time;
    });
    return corners;
}

// A chord ends where the ball met something within the step, so that its path does not cut that corner off.
void write_corner(World& world, History& history, Event const& event) {
    Leg const leg = world.legs[event.ball];
    if (event.time > leg.since)
        write_leg(world, history, event.ball, event.time, {event.state, leg.phase, leg.contact});
}

void write_step(Stage& stage, World& world, double then, History& history, std::size_t first_event) {
    count_still(stage, world);
    std::vector<Event> const corners = corners_of_step(stage, world, then, history, first_event);
    auto corner = corners.begin();
    for (Traveller& traveller : stage.travellers) {
        int const i = traveller.index;
        if (stage.asleep[i]) continue;
        open_leg(world, history, i, world.time);
        Leg const before = world.legs[i];
        for (; corner != corners.end() && corner->ball == i; ++corner) write_corner(world, history, *corner);
        write_leg(world, history, i, then, {traveller.state, phase_of(traveller), traveller.contact});
        if (stage.leaning[i]) tell_contact_change(stage.scene.terrain, before, world.legs[i], i, history);
        tell_phase_change(before, world.legs[i], i, history);
    }
}

void skip_steps(Steps const& method, World& world, double until) {
    while (world.time < until) world.time = time_of_step(world, method.rate, ++world.steps_taken);
}

}  // namespace

void advance_with(Steps const& method, Scene const& scene, World& world, double until, History& history) {
    if (all_asleep(scene, world)) return skip_steps(method, world, until);
    std::size_t const first_event = history.events.size();
    Stage stage = stage_of(scene, world);
    double const step = 1 / method.rate, pace = step / method.substeps;
    while (world.time < until) {
        double const then = time_of_step(world, method.rate, world.steps_taken + 1);
        if (!all_asleep(scene, world)) {
            std::size_t const first_of_step = history.events.size();
            put_to_sleep(stage, world, pace);
            find_neighbours(stage, step);
            if (!move_alone(stage, {scene.terrain, world.time, step, pace, history.events}))
                for (int i = 0; i < method.substeps; ++i)
                    move_all(stage, {scene.terrain, world.time + i * pace, pace, pace, history.events});
            write_step(stage, world, then, history, first_of_step);
        }
        ++world.steps_taken;
        world.time = then;
    }
    leave(stage, world);
    sort_events(history, first_event);
}

}  // namespace physics
