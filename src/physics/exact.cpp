#include "physics/exact.h"

#include <algorithm>
#include <numeric>

#include "physics/handover.h"
#include "physics/meetings.h"
#include "physics/ride.h"
#include "physics/steps.h"

namespace physics {

namespace {

// One call's view of the world: what does not change, and where legs and events go.
class Timeline {
public:
    // `alone`: balls go by the rules of one that is alone in its world, and are not looked for by others.
    Timeline(Scene const& scene, World& world, History& history, bool alone = false)
        : scene_(scene), world_(world), history_(history), alone_(alone || scene.balls.size() == 1) {}

    void begin() {
        world_.quiet_until = -never;
        world_.legs.resize(scene_.balls.size());
        world_.outlooks.assign(scene_.balls.size(), {});
        history_.legs.assign(scene_.balls.size(), {});
        for (int i = 0; i < count(); ++i) resolve(i, scene_.balls[i].start, no_contact);
        look_for_meetings(scene_, world_, everyone());
    }

    void take_back() {
        world_.quiet_until = -never;
        look_for_meetings(scene_, world_, everyone());
    }

    void resolve(int i, State const& state, Contact known) {
        take(i, resolved(setting(i), state, world_.time, known), world_.time);
    }

    // After a hit, whether by another ball or in how it is borne.
    void strike(int i, State const& state) { take(i, after_hit(i, state), world_.time); }

    // The events of one ball up to and including `until`.
    void follow(int i, double until) {
        while (world_.legs[i].until <= until) {
            world_.time = std::max(world_.time, world_.legs[i].until);
            end_leg(i);
        }
    }

    void change_field(int i) {
        take(i, under_new_field(setting(i), world_.legs[i], world_.outlooks[i], world_.time), world_.time);
    }

    // Events up to and including `until`; or the ball that must be handed over at world.time, with those that it touches.
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
            if (was.gravity == is.gravity && was.target == is.target && was.pulled == is.pulled) continue;
            change_field(i);
            touched.push_back(i);
        }
        look_for_meetings(scene_, world_, touched);
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
    Setting setting(int i) const {
        Field const field = field_on(scene_, world_.forces, i);
        Outlook const& outlook = world_.outlooks[i];
        bool const has_a_limit = !field.pulled && !outlook.watch_mixed && !outlook.watch_elastic;
        int const most = outlook.watch_mixed ? crowd_events : crowd_events / 2;
        bool const crowded = alone_ && outlook.watch_count > most && !has_a_limit;
        return {scene_.terrain, scene_.balls[i], field, crowded};
    }

    // Phase changes before hits, lower balls first (physics.md 3.4).
    Next soonest() const {
        Next next;
        for (int i = 0; i < count(); ++i)
            if (world_.legs[i].until < next.time) next = {world_.legs[i].until, i, false};
        if (count() > 1)
            for (int i = 0; i < count(); ++i)
                if (world_.outlooks[i].hit_time < next.time - moment) next = {world_.outlooks[i].hit_time, i, true};
        return next;
    }

    void tell(EventKind kind, int ball, State const& state, Contact contact, int other) {
        history_.events.push_back({world_.time, kind, ball, state, contact, other});
    }

    // Makes a turnout the ball's present.
    void take(int i, Turnout const& turnout, double time) {
        Course const& course = turnout.course;
        Trail<Leg>& legs = history_.legs[i];
        // A leg that lasted no time leaves no trace; one that goes on is the same leg, known further ahead.
        if (!legs.empty() && legs.back().since >= course.leg.since) legs.pop_back();
        if (!legs.empty()) legs.back().until = std::min(legs.back().until, course.leg.since);
        legs.push_back(course.leg);
        world_.legs[i] = course.leg;
        Outlook& outlook = world_.outlooks[i];
        outlook.ending = course.ending;
        outlook.duration = course.duration;
        outlook.next = course.next;
        outlook.next_q = course.next_q;
        outlook.onset = course.onset;
        outlook.ends = turnout.ends;
        outlook.clearing.contact = no_contact;
        for (Turnout::Happening const& happening : turnout.happenings)
            tell(happening.kind, i, at(course.leg, time), happening.contact, -1);
    }

    bool watched(int i) {
        Outlook& outlook = world_.outlooks[i];
        if (world_.time - outlook.watch_since > watch_span) {
            outlook.watch_since = world_.time;
            outlook.watch_count = 0;
            outlook.watch_contact = outlook.next;
            outlook.watch_mixed = false;
            outlook.watch_elastic = false;
        }
        outlook.watch_mixed = outlook.watch_mixed || outlook.next != outlook.watch_contact;
        outlook.watch_elastic = outlook.watch_elastic || is_elastic(outlook.next);
        return ++outlook.watch_count <= watch_events;
    }

    bool is_elastic(Contact contact) const {
        return contact.feature >= 0 && material_of(scene_.terrain, contact.feature).restitution > most_summed;
    }

    // Counts the events of a lone ball within short spans: first they crowd, then, though no rule of ours should let them,
    // they stall.
    bool stalls(int i) {
        Outlook& outlook = world_.outlooks[i];
        if (world_.time - outlook.stall_since > stall_span) {
            outlook.stall_since = world_.time;
            outlook.stall_count = 0;
        }
        if (outlook.ending == Ending::meets || outlook.ending == Ending::settles) watched(i);
        return ++outlook.stall_count > stall_events;
    }

    // Whether creeping takes it nowhere either.
    bool jams(int i) {
        Outlook& outlook = world_.outlooks[i];
        if (world_.time - outlook.creep_since > watch_span) {
            outlook.creep_since = world_.time;
            outlook.creep_count = 0;
        }
        return ++outlook.creep_count > creep_events;
    }

    bool end_leg(int i) {
        if (!alone_ && !watched(i)) return false;
        if (alone_ && stalls(i)) {
            State const state = at_span(world_.legs[i], world_.outlooks[i].duration);
            take(i, jams(i) ? jammed(state, world_.legs[i].contact, world_.time) : creeping(setting(i), state, world_.time),
                 world_.time);
            return true;
        }
        bool const same_motion = world_.outlooks[i].ending == Ending::goes_on && world_.legs[i].phase == Phase::flight;
        if (!hop(i) && !pass(i)) {
            Outlook const before = world_.outlooks[i];
            take(i, after_end(setting(i), world_.legs[i], before), world_.time);
            look_round(i, before);
        }
        if (!alone_ && !same_motion) look_for_meetings(scene_, world_, {&i, 1});
        return true;
    }

    // Where the same is likely to happen again, it need not be worked out again what lies around.
    void look_round(int i, Outlook const& before) {
        Leg const& leg = world_.legs[i];
        Outlook& outlook = world_.outlooks[i];
        auto const* motion = std::get_if<Ballistic>(&leg.motion);
        if (motion == nullptr || outlook.ending != before.ending) return;
        if (outlook.ending == Ending::meets && leg.phase == Phase::flight && outlook.next == before.next)
            outlook.clearing =
                clearing_of_hop(scene_.terrain, scene_.balls[i], outlook.next, *motion, outlook.duration);
        if (outlook.ending == Ending::joins && leg.phase == Phase::roll)
            outlook.clearing = clearing_of_roll(scene_.terrain, scene_.balls[i], leg.contact, before.next_q, *motion);
    }

    // The same motion as until now, from another state.
    void set_out(int i, State const& state, Contact contact, double duration, EventKind kind, Contact at_what) {
        Leg& leg = world_.legs[i];
        leg.since = world_.time;
        leg.until = world_.time + duration;
        leg.contact = contact;
        std::get<Ballistic>(leg.motion).from = state;
        history_.legs[i].push_back(leg);
        world_.outlooks[i].duration = duration;
        tell(kind, i, state, at_what, -1);
    }

    bool hop(int i) {
        Outlook const& outlook = world_.outlooks[i];
        Contact const floor = outlook.clearing.contact;
        if (outlook.ending != Ending::meets || floor.feature < 0) return false;
        if (outlook.watch_elastic && outlook.watch_count > crowd_events / 2) return false;
        auto const next = next_hop(outlook.clearing, scene_.terrain, scene_.balls[i],
                                   std::get<Ballistic>(world_.legs[i].motion), outlook.duration);
        if (next) set_out(i, next->state, no_contact, next->duration, EventKind::bounce, floor);
        return next.has_value();
    }

    bool pass(int i) {
        Outlook& outlook = world_.outlooks[i];
        if (outlook.ending != Ending::joins || outlook.clearing.contact.feature < 0) return false;
        auto const next = next_crossing(outlook.clearing, scene_.terrain, scene_.balls[i],
                                        std::get<Ballistic>(world_.legs[i].motion), outlook.duration);
        if (!next) return false;
        Contact const piece = next->there.contact;
        TrackEnd const& goal = next->towards > 0 ? next->ends.high : next->ends.low;
        outlook.clearing.here = next->there;
        outlook.ends = next->ends;
        outlook.next = goal.next;
        outlook.next_q = goal.next_q;
        set_out(i, next->state, piece, next->duration, EventKind::joint, piece);
        return true;
    }

    // All pairs that close at this moment strike together. False when balls press on each other without closing.
    bool hit(int i) {
        if (world_.outlooks[i].hit_ball < 0) {
            look_for_meetings(scene_, world_, {&i, 1});
            return true;
        }
        if (!watched(i)) return false;
        std::vector<State> states;
        states.reserve(scene_.balls.size());
        for (int b = 0; b < count(); ++b) states.push_back(at(world_.legs[b], world_.time));
        std::vector<Pair> const pairs = closing_pairs(scene_, world_, states);
        if (pairs.empty()) return false;
        strike_together(scene_.balls, pairs, states);
        std::vector<int> touched;
        for (Pair const& p : pairs) {
            tell(EventKind::hit, p.a, states[p.a], no_contact, p.b);
            touched.insert(touched.end(), {p.a, p.b});
        }
        std::sort(touched.begin(), touched.end());
        touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
        for (int const b : touched) strike(b, states[b]);
        look_for_meetings(scene_, world_, touched);
        return true;
    }

    // What a hit does to a ball that touches terrain: it lifts, slips, grips or rests, but does not land where it was.
    Turnout after_hit(int i, State const& state) const {
        Leg const& before = world_.legs[i];
        Turnout turnout = resolved(setting(i), state, world_.time, no_contact);
        if (before.phase == Phase::flight) return turnout;
        auto& happenings = turnout.happenings;
        std::erase_if(happenings, [&](Turnout::Happening const& h) {
            return h.contact == before.contact && h.kind != EventKind::bounce && h.kind != EventKind::lift;
        });
        bool const told = std::any_of(happenings.begin(), happenings.end(),
                                      [&](Turnout::Happening const& h) { return h.contact == before.contact; });
        Phase const phase = turnout.course.leg.phase;
        if (!told && phase != before.phase)
            happenings.push_back({phase == Phase::flight ? EventKind::lift : kind_of(phase), before.contact});
        return turnout;
    }

    Scene const& scene_;
    World& world_;
    History& history_;
    bool alone_;
};

// The world's clock, put to another time for a while.
class Clock {
public:
    Clock(World& world, double time) : world_(world), now_(world.time) { world.time = time; }
    ~Clock() { world_.time = now_; }
    Clock(Clock const&) = delete;
    Clock& operator=(Clock const&) = delete;

private:
    World& world_;
    double now_;
};

}  // namespace

void begin_with(Exact const&, Scene const& scene, World& world, History& history) {
    Timeline(scene, world, history).begin();
}

namespace {

void pass_events(Scene const& scene, World& world, double until, History& history) {
    while (world.time < until) {
        if (world.handed_over) {
            step_handed_over(scene, world, until, history);
            if (!is_apart(scene, world)) continue;
            take_back(scene, world, history);
            Timeline(scene, world, history).take_back();
        } else if (auto const ball = Timeline(scene, world, history).run(until)) {
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
        Timeline(scene, world, history).refresh(before);
}

void set_out(Scene const& scene, World& world, History& history, int ball, State const& state, Contact known,
             double time) {
    Clock const clock(world, time);
    Timeline(scene, world, history, true).resolve(ball, state, known);
}

void strike(Scene const& scene, World& world, History& history, int ball, State const& state, double time) {
    Clock const clock(world, time);
    Timeline(scene, world, history, true).strike(ball, state);
}

void follow_plan(Scene const& scene, World& world, History& history, int ball, double until) {
    if (world.legs[ball].until > until) return;
    Clock const clock(world, world.legs[ball].since);
    Timeline(scene, world, history, true).follow(ball, until);
}

void change_field(Scene const& scene, World& world, History& history, int ball, double time) {
    Clock const clock(world, time);
    Timeline(scene, world, history, true).change_field(ball);
}

}  // namespace physics
