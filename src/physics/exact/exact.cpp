#include "physics/exact/exact.h"

#include <algorithm>
#include <numeric>

#include "physics/exact/handover.h"
#include "physics/exact/pair_schedule.h"
#include "physics/plan/planned_balls.h"
#include "physics/steps/steps.h"

namespace physics {

namespace {

// Time goes from one event of all balls to the next: detect (soonest), resolve (end_leg, hit).
class EventLoop {
public:
    EventLoop(Scene const& scene, World& world, History& history)
        : scene_(scene), world_(world), history_(history), balls_(scene, world, history, scene.balls.size() == 1) {}

    void begin() {
        world_.legs.resize(scene_.balls.size());
        world_.plans.assign(scene_.balls.size(), {});
        history_.legs.assign(scene_.balls.size(), {});
        for (int i = 0; i < count(); ++i) balls_.resolve(i, scene_.balls[i].start, no_contact);
        look_anew();
    }

    // Nothing is known of who meets whom.
    void look_anew() {
        world_.quiet_until = -never;
        schedule_hits(scene_, world_, everyone());
    }

    // Events up to and including `until`; or the ball that must be handed over at world.time, with those that it
    // touches.
    std::optional<int> run(double until) {
        while (true) {
            Next const next = soonest();
            world_.quiet_until = next.time;
            if (next.time > until) break;
            world_.time = std::max(world_.time, next.time);
            if (next.is_hit ? !hit(next.ball) : !end_leg(next.ball)) return next.ball;
        }
        world_.time = until;
        return std::nullopt;
    }

    void refresh(Forces const& before) {
        world_.quiet_until = -never;
        std::vector<int> touched;
        for (int i = 0; i < count(); ++i) {
            Field const was = field_on(scene_, before, i), is = field_on(scene_, world_.forces, i);
            if (!is_other(was, is)) continue;
            balls_.change_field(i);
            touched.push_back(i);
        }
        schedule_hits(scene_, world_, touched);
    }

private:
    struct Next {
        double time = never;
        int ball = -1;
        bool is_hit = false;
    };

    int count() const { return static_cast<int>(scene_.balls.size()); }
    std::vector<int> everyone() const {
        std::vector<int> all(scene_.balls.size());
        std::iota(all.begin(), all.end(), 0);
        return all;
    }
    // Phase changes before hits, lower balls first (physics.md 8.4).
    Next soonest() const {
        Next next;
        for (int i = 0; i < count(); ++i)
            if (world_.legs[i].until < next.time) next = {world_.legs[i].until, i, false};
        if (count() > 1)
            for (int i = 0; i < count(); ++i)
                if (world_.plans[i].hit_time < next.time - moment) next = {world_.plans[i].hit_time, i, true};
        return next;
    }

    // False when events of the ball crowd.
    bool end_leg(int i) {
        PlannedBalls::Going const going = balls_.end_leg(i);
        if (going == PlannedBalls::Going::changed) schedule_hits(scene_, world_, {&i, 1});
        return going != PlannedBalls::Going::crowded;
    }

    // All pairs that close at this moment strike together. False when balls press on each other without closing.
    bool hit(int i) {
        if (world_.plans[i].hit_ball < 0) {
            schedule_hits(scene_, world_, {&i, 1});
            return true;
        }
        if (!balls_.watched(i)) return false;
        std::vector<State> states;
        states.reserve(scene_.balls.size());
        for (int b = 0; b < count(); ++b) states.push_back(at(world_.legs[b], world_.time));
        std::vector<Pair> const pairs = closing_pairs(scene_, world_, states);
        if (pairs.empty()) return false;
        solve_simultaneous_impacts(scene_.balls, pairs, states);
        std::vector<int> touched;
        for (Pair const& p : pairs) {
            history_.events.push_back({world_.time, EventKind::hit, p.a, states[p.a], no_contact, p.b});
            touched.insert(touched.end(), {p.a, p.b});
        }
        std::sort(touched.begin(), touched.end());
        touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
        for (int const b : touched) balls_.strike(b, states[b]);
        schedule_hits(scene_, world_, touched);
        return true;
    }

    Scene const& scene_;
    World& world_;
    History& history_;
    PlannedBalls balls_;
};

}  // namespace

void begin_with(Exact const&, Scene const& scene, World& world, History& history) {
    EventLoop(scene, world, history).begin();
}

namespace {

void pass_events(Scene const& scene, World& world, double until, History& history) {
    while (world.time < until) {
        if (world.handed_over) {
            step_handed_over(scene, world, until, history);
            if (!is_apart(scene, world)) continue;
            take_back(scene, world, history);
            EventLoop(scene, world, history).look_anew();
        } else if (auto const ball = EventLoop(scene, world, history).run(until)) {
            hand_over(scene, world, *ball, history);
        }
    }
}

}  // namespace

void advance_with(Exact const&, Scene const& scene, World& world, double until, History& history) {
    if (until < world.quiet_until)
        world.time = until;
    else
        pass_events(scene, world, until, history);
}

void force_with(Exact const&, Scene const& scene, World& world, Forces const& before, History& history) {
    if (world.handed_over)
        force_with(Steps{handover_rate}, scene, world, before, history);
    else
        EventLoop(scene, world, history).refresh(before);
}

}  // namespace physics
