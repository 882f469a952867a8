#include "physics/plan/planned_balls.h"

#include <algorithm>

#include "physics/plan/corridor.h"

namespace physics {

namespace {

// Whether it does: after `span`, s.
bool begins_anew(Tally& tally, double time, double span) {
    if (time - tally.since <= span) return false;
    tally = {time, 0};
    return true;
}

}  // namespace

MotionContext PlannedBalls::context(int i) const {
    Field const field = field_on(scene_, world_.forces, i);
    BallPlan const& plan = world_.plans[i];
    bool const has_a_limit = !field.pulled && !plan.watch_mixed && !plan.watch_elastic;
    int const most = plan.watch_mixed ? crowd_events : crowd_events / 2;
    bool const crowded = alone_ && (plan.watch.count > most || plan.frame.count > frame_events) && !has_a_limit;
    return {scene_.terrain, scene_.balls[i], field, crowded, alone_ && plan.frame.count > many_events, horizon_};
}

void PlannedBalls::tell(EventKind kind, int i, State const& state, Contact contact) {
    history_.events.push_back({world_.time, kind, i, state, contact, -1});
}

// Makes a transition the ball's present.
void PlannedBalls::take(int i, Transition const& transition) {
    Leg const& next = transition.plan.leg;
    Trail<Leg>& legs = history_.legs[i];
    // A leg that lasted no time leaves no trace; one that goes on is the same leg, known further ahead.
    if (!legs.empty() && legs.back().since >= next.since) legs.pop_back();
    if (!legs.empty()) legs.back().until = std::min(legs.back().until, next.since);
    legs.push_back(next);
    world_.legs[i] = next;
    BallPlan& plan = world_.plans[i];
    plan.end = transition.plan.end;
    plan.track_ends = transition.track_ends;
    plan.corridor.contact = no_contact;
    for (Transition::ContactEvent const& event : transition.contact_events)
        tell(event.kind, i, at(next, world_.time), event.contact);
}

bool PlannedBalls::watched(int i) {
    BallPlan& plan = world_.plans[i];
    Contact const contact = plan.end.next;
    if (begins_anew(plan.watch, world_.time, watch_span)) {
        plan.watch_contact = contact;
        plan.watch_mixed = false;
        plan.watch_elastic = false;
    }
    begins_anew(plan.frame, world_.time, frame_span);
    ++plan.frame.count;
    bool const in_socket = contact.feature >= 0 && !fits(scene_.terrain, contact, scene_.balls[i].radius);
    plan.watch_mixed = plan.watch_mixed || contact != plan.watch_contact || in_socket;
    plan.watch_elastic = plan.watch_elastic || is_elastic(contact);
    return ++plan.watch.count <= watch_events;
}

bool PlannedBalls::is_elastic(Contact contact) const {
    return contact.feature >= 0 && material_of(scene_.terrain, contact.feature).restitution > most_summed;
}

// Whether the speed that the ball has come to would not take it out of touch against the pull.
bool PlannedBalls::stays_in_touch(int i) const {
    State const state = at_span(world_.legs[i], world_.plans[i].end.time);
    double const pull =
        geometry::length(acceleration_in(field_on(scene_, world_.forces, i), state.position, state.velocity));
    return state.velocity.squaredNorm() <= 2 * pull * touch_reach;
}

// Counts the events of a lone ball within short spans: first they crowd, then, though no rule of ours should let them,
// they stall.
bool PlannedBalls::stalls(int i) {
    BallPlan& plan = world_.plans[i];
    begins_anew(plan.stall, world_.time, stall_span);
    begins_anew(plan.flips, world_.time, flip_span);
    LegEndCause const cause = plan.end.cause;
    if (cause == LegEndCause::meets || cause == LegEndCause::settles) watched(i);
    if (cause == LegEndCause::lifts || cause == LegEndCause::slips || cause == LegEndCause::grips) ++plan.flips.count;
    bool const goes_on = plan.watch_mixed && plan.frame.count > most_frame_events && stays_in_touch(i);
    return ++plan.stall.count > stall_events || plan.flips.count > flip_events || goes_on;
}

// Whether creeping takes it nowhere either.
bool PlannedBalls::jams(int i) {
    BallPlan& plan = world_.plans[i];
    begins_anew(plan.creeps, world_.time, watch_span);
    return ++plan.creeps.count > creep_events;
}

void PlannedBalls::creep(int i) {
    BallPlan& plan = world_.plans[i];
    State state = at_span(world_.legs[i], plan.end.time);
    bool stands = false;
    if (jams(i)) {
        stands = world_.time - plan.jammed_at <= frame_span;
        plan.jammed_at = world_.time;
        state.velocity = Vec2::Zero();
        state.spin = 0;
    }
    take(i, stands ? jammed(state, world_.legs[i].contact, world_.time) : creeping(context(i), state, world_.time));
    if (plan.flips.count <= flip_events) return;
    plan.flips.since = std::min(world_.legs[i].until, world_.time + watch_span);
    plan.flips.count = flip_events - flips_again;
}

PlannedBalls::Going PlannedBalls::end_leg(int i) {
    if (!alone_ && !watched(i)) return Going::crowded;
    if (alone_ && stalls(i)) {
        creep(i);
        return Going::changed;
    }
    bool const same_motion = world_.plans[i].end.cause == LegEndCause::goes_on && world_.legs[i].phase == Phase::flight;
    if (!hop(i) && !pass(i)) {
        BallPlan const before = world_.plans[i];
        take(i, after_end(context(i), world_.legs[i], before));
        look_round(i, before);
    }
    return same_motion ? Going::on : Going::changed;
}

// Where the same is likely to happen again, it need not be worked out again what lies around.
void PlannedBalls::look_round(int i, BallPlan const& before) {
    Leg const& leg = world_.legs[i];
    BallPlan& plan = world_.plans[i];
    auto const* motion = std::get_if<Ballistic>(&leg.motion);
    if (motion == nullptr || plan.end.cause != before.end.cause) return;
    if (plan.end.cause == LegEndCause::meets && leg.phase == Phase::flight && plan.end.next == before.end.next)
        plan.corridor = corridor_of_hop(scene_.terrain, scene_.balls[i], plan.end.next, *motion, plan.end.time);
    if (plan.end.cause == LegEndCause::joins && leg.phase == Phase::roll)
        plan.corridor = corridor_of_roll(scene_.terrain, scene_.balls[i], leg.contact, before.end.next_q, *motion);
}

// The same motion as until now, from another state.
void PlannedBalls::set_out(int i, State const& state, Contact contact, double duration, EventKind kind,
                           Contact at_what) {
    Leg& leg = world_.legs[i];
    leg.since = world_.time;
    leg.until = world_.time + duration;
    leg.contact = contact;
    std::get<Ballistic>(leg.motion).from = state;
    history_.legs[i].push_back(leg);
    world_.plans[i].end.time = duration;
    tell(kind, i, state, at_what);
}

bool PlannedBalls::hop(int i) {
    BallPlan const& plan = world_.plans[i];
    Contact const floor = plan.corridor.contact;
    if (plan.end.cause != LegEndCause::meets || floor.feature < 0) return false;
    if (plan.frame.count > many_events) return false;
    if (plan.watch_elastic && (plan.watch.count > crowd_events / 2 || plan.frame.count > frame_events)) return false;
    auto const next = next_hop(plan.corridor, scene_.terrain, scene_.balls[i],
                               std::get<Ballistic>(world_.legs[i].motion), plan.end.time);
    if (next) set_out(i, next->state, no_contact, next->duration, EventKind::bounce, floor);
    return next.has_value();
}

bool PlannedBalls::pass(int i) {
    BallPlan& plan = world_.plans[i];
    if (plan.end.cause != LegEndCause::joins || plan.corridor.contact.feature < 0) return false;
    auto const next = next_crossing(plan.corridor, scene_.terrain, scene_.balls[i],
                                    std::get<Ballistic>(world_.legs[i].motion), plan.end.time);
    if (!next) return false;
    Contact const piece = next->there.contact;
    TrackEnd const& goal = next->towards > 0 ? next->ends.high : next->ends.low;
    plan.corridor.here = next->there;
    plan.track_ends = next->ends;
    plan.end.next = goal.next;
    plan.end.next_q = goal.next_q;
    set_out(i, next->state, piece, next->duration, EventKind::joint, piece);
    return true;
}

// What a hit does to a ball that touches terrain: it lifts, slips, grips or rests, but does not land where it was.
Transition PlannedBalls::after_hit(int i, State const& state) const {
    Leg const& before = world_.legs[i];
    Transition transition = resolved(context(i), state, world_.time, no_contact);
    if (before.phase == Phase::flight) return transition;
    auto& contact_events = transition.contact_events;
    std::erase_if(contact_events, [&](Transition::ContactEvent const& h) {
        return h.contact == before.contact && h.kind != EventKind::bounce && h.kind != EventKind::lift;
    });
    bool const told = std::any_of(contact_events.begin(), contact_events.end(),
                                  [&](Transition::ContactEvent const& h) { return h.contact == before.contact; });
    Phase const phase = transition.plan.leg.phase;
    if (!told && phase != before.phase)
        contact_events.push_back({phase == Phase::flight ? EventKind::lift : kind_of(phase), before.contact});
    return transition;
}

void PlannedBalls::resolve(int i, State const& state, Contact known) {
    take(i, resolved(context(i), state, world_.time, known));
}

void PlannedBalls::strike(int i, State const& state) { take(i, after_hit(i, state)); }

void PlannedBalls::change_field(int i) {
    take(i, under_new_field(context(i), world_.legs[i], world_.plans[i], world_.time));
}

void PlannedBalls::follow(int i, double until) {
    while (world_.legs[i].until <= until) {
        world_.time = std::max(world_.time, world_.legs[i].until);
        end_leg(i);
    }
}

namespace {

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

void set_out(Scene const& scene, World& world, History& history, int ball, State const& state, Contact known,
             double time, double horizon) {
    Clock const clock(world, time);
    PlannedBalls(scene, world, history, true, horizon).resolve(ball, state, known);
}

void strike(Scene const& scene, World& world, History& history, int ball, State const& state, double time) {
    Clock const clock(world, time);
    PlannedBalls(scene, world, history, true).strike(ball, state);
}

void follow_plan(Scene const& scene, World& world, History& history, int ball, double until) {
    if (world.legs[ball].until > until) return;
    Clock const clock(world, world.legs[ball].since);
    PlannedBalls(scene, world, history, true).follow(ball, until);
}

void change_field(Scene const& scene, World& world, History& history, int ball, double time) {
    Clock const clock(world, time);
    PlannedBalls(scene, world, history, true).change_field(ball);
}

void advance_alone(Scene const& scene, World& world, History& history, double until) {
    if (world.legs[0].until <= until) PlannedBalls(scene, world, history, true).follow(0, until);
    world.time = until;
}

void force_alone(Scene const& scene, World& world, History& history, Forces const& before) {
    if (is_other(field_on(scene, before, 0), field_on(scene, world.forces, 0)))
        PlannedBalls(scene, world, history, true).change_field(0);
}

}  // namespace physics
