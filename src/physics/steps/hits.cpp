#include "physics/steps/hits.h"

#include <algorithm>
#include <cmath>

#include "physics/plan/planned_balls.h"
#include "physics/steps/lone_balls.h"
#include "physics/steps/simultaneous.h"

namespace physics {

using geometry::dot;
using geometry::length;

namespace {

void forget_events(StepContext& context, int ball, double from) {
    Trail<Event>& events = context.history.events;
    auto const late = [&](Event const& e) { return e.ball == ball && e.time > from && e.kind != EventKind::hit; };
    auto const first = events.begin() + static_cast<std::ptrdiff_t>(context.told);
    events.cut(std::remove_if(first, events.end(), late));
}

// How hard two touching balls are pressed together by what acts on them, as far as it can be told: two in free flight
// fall alike, but ground beneath one, or a third ball, may hold it against the other.
double pressing_on(StepContext const& context, BallPair const& e, Vec2 const& normal) {
    BodyState const& a = context.body_states[e.first];
    BodyState const& b = context.body_states[e.second];
    Vec2 const pull_a = acceleration_in(*a.field, a.state.position, a.state.velocity);
    Vec2 const pull_b = acceleration_in(*b.field, b.state.position, b.state.velocity);
    bool const held =
        a.contact.feature >= 0 || b.contact.feature >= 0 || context.leaning[e.first] || context.leaning[e.second];
    if (held) return std::max(length(pull_a), length(pull_b));
    return std::max(0.0, dot(pull_a - pull_b, normal));
}

// A hit as it is found.
struct Blow {
    int pair = 0;
    Vec2 normal = Vec2::Zero();
    double closing = 0;      // m/s
    double pressing = 0;     // m/s^2
    double restitution = 0;  // 0 if it does not bounce
    bool bounces = false;
};

Blow blow_between(StepContext const& context, Substep const& substep, int pair) {
    BallPair const& e = context.ball_pairs[pair];
    BodyState const& a = context.body_states[e.first];
    BodyState const& b = context.body_states[e.second];
    Vec2 const d = b.state.position - a.state.position;
    double const distance = length(d);
    Blow blow;
    blow.pair = pair;
    blow.normal = distance > 0 ? Vec2(d / distance) : Vec2(0, 1);
    blow.pressing = pressing_on(context, e, blow.normal);
    blow.closing = closing_of(context, e);
    double const restitution = restitution_between(*a.ball, *b.ball);
    blow.bounces = restitution * blow.closing > 2 * blow.pressing * substep.length;
    blow.restitution = blow.bounces ? restitution : 0;
    return blow;
}

std::vector<ContactPush> pushes_of(StepContext const& context, std::vector<Blow> const& blows) {
    std::vector<ContactPush> pushes;
    for (Blow const& blow : blows) {
        BallPair const& e = context.ball_pairs[blow.pair];
        pushes.push_back({e.first, e.second, blow.normal, 1 / context.body_states[e.first].ball->mass,
                          1 / context.body_states[e.second].ball->mass, (1 + blow.restitution) * blow.closing});
    }
    return pushes;
}

void add_impulse(BodyState& body_state, Vec2 const& impulse, double tangent) {
    Ball const& ball = *body_state.ball;
    body_state.state.velocity += impulse / ball.mass;
    body_state.state.spin += tangent / (ball.inertia * ball.mass * ball.radius);
}

// The largest number of blows that one of the pair's balls takes.
int crowd_of(std::vector<ContactPush> const& pushes, ContactPush const& push) {
    auto const on = [&](int ball) {
        return std::count_if(pushes.begin(), pushes.end(),
                             [&](ContactPush const& p) { return p.first == ball || p.second == ball; });
    };
    return static_cast<int>(std::max(on(push.first), on(push.second)));
}

// Each contact's friction as if it were alone, in the parts in which its balls share it: the mean of impulses none of
// which gains energy gains none.
void rub_together(StepContext& context, std::vector<ContactPush> const& pushes, std::vector<double> const& normals) {
    std::vector<double> tangents;
    for (std::size_t i = 0; i < pushes.size(); ++i) {
        ContactPush const& push = pushes[i];
        BodyState const& a = context.body_states[push.first];
        BodyState const& b = context.body_states[push.second];
        double const slip = dot(b.state.velocity - a.state.velocity, geometry::turned_right(push.normal)) +
                            a.ball->radius * a.state.spin + b.ball->radius * b.state.spin;
        double const yield =
            (1 + 1 / a.ball->inertia) * push.first_yield + (1 + 1 / b.ball->inertia) * push.second_yield;
        double const grip = normals[i] > 0 ? friction_between(*a.ball, *b.ball) * normals[i] : 0;
        tangents.push_back(std::clamp(-slip / (yield * crowd_of(pushes, push)), -grip, grip));
    }
    for (std::size_t i = 0; i < pushes.size(); ++i) {
        Vec2 const impulse = tangents[i] * geometry::turned_right(pushes[i].normal);
        add_impulse(context.body_states[pushes[i].first], -impulse, tangents[i]);
        add_impulse(context.body_states[pushes[i].second], impulse, tangents[i]);
    }
}

void solve_simultaneous_impacts(StepContext& context, std::vector<Blow> const& blows) {
    std::vector<ContactPush> const pushes = pushes_of(context, blows);
    std::vector<double> const normals = least_pushes(pushes);
    for (std::size_t i = 0; i < pushes.size(); ++i) {
        Vec2 const impulse = normals[i] * pushes[i].normal;
        add_impulse(context.body_states[pushes[i].first], -impulse, 0);
        add_impulse(context.body_states[pushes[i].second], impulse, 0);
    }
    rub_together(context, pushes, normals);
}

void strike(StepContext& context, Blow const& blow) {
    BallPair const& e = context.ball_pairs[blow.pair];
    BodyState& a = context.body_states[e.first];
    BodyState& b = context.body_states[e.second];
    PairImpact const impact = after_pair_impact(a.state, *a.ball, b.state, *b.ball, blow.normal, blow.restitution);
    a.state = impact.first;
    b.state = impact.second;
}

// What does not bounce leans from now on; what closed faster than balls do that lean is a hit.
void lean_or_tell(StepContext& context, Substep const& substep, Blow const& blow, double time) {
    BallPair& e = context.ball_pairs[blow.pair];
    if (!blow.bounces && blow.pressing > 0) {
        context.regroup = context.regroup || !e.leaning;
        e.leaning = true;
        context.leaning[e.first] = context.leaning[e.second] = 1;
    }
    if (blow.closing > 2 * blow.pressing * substep.length)
        context.history.events.push_back(
            {substep.since + time, EventKind::hit, e.first, context.body_states[e.first].state, no_contact, e.second});
}

}  // namespace

Vec2 on_the_way(StepContext const& context, Substep const& substep, int ball, double time) {
    if (!is_stepped(context.world, ball)) return state_at(context.history, ball, substep.since + time).position;
    Departure const& from = context.departures[ball];
    if (time == from.time) return from.state.position;
    Vec2 const& to = context.body_states[ball].state.position;
    double const span = substep.length - from.time;
    return span > 0 ? Vec2(from.state.position + ((time - from.time) / span) * (to - from.state.position)) : to;
}

double closing_of(StepContext const& context, BallPair const& e) {
    State const& a = context.body_states[e.first].state;
    State const& b = context.body_states[e.second].state;
    Vec2 const d = b.position - a.position;
    double const distance = length(d);
    return distance > 0 ? -dot(b.velocity - a.velocity, d) / distance : 0;
}

void mark_struck(StepContext& context, int ball) {
    if (!context.struck[ball]) context.struck_balls.push_back(ball);
    context.struck[ball] = 1;
}

void go_back(StepContext& context, Substep const& substep, int ball, double time) {
    if (context.asleep[ball]) return;
    if (is_stepped(context.world, ball)) {
        context.body_states[ball].state.position = on_the_way(context, substep, ball, time);
        return;
    }
    forget_events(context, ball, substep.since + context.departures[ball].time);
    return_to_departure(context, ball);
    follow(context, ball, substep.since + time);
}

void go_on(StepContext& context, Substep const& substep, int ball, double time) {
    double const now = substep.since + time;
    if (context.asleep[ball]) context.regroup = context.relist = true;
    context.asleep[ball] = 0;
    mark_struck(context, ball);
    context.body_states[ball].still = false;
    if (context.leaning[ball]) {
        if (!is_stepped(context.world, ball)) begin_chord(context, ball, now);
        depart(context, ball, time, substep.end());
        sweep(context, ball, now, substep.length - time);
    } else {
        strike(context.scene, context.world, context.history, ball, context.body_states[ball].state, now);
        follow(context, ball, now);
        depart(context, ball, time, substep.end());
        follow(context, ball, substep.end());
    }
}

void hit(StepContext& context, Substep const& substep, std::vector<int> const& pairs, double time) {
    if (pairs.size() == 1) {
        Blow const blow = blow_between(context, substep, pairs.front());
        strike(context, blow);
        lean_or_tell(context, substep, blow, time);
        return;
    }
    std::vector<Blow> blows;
    for (int const k : pairs) blows.push_back(blow_between(context, substep, k));
    solve_simultaneous_impacts(context, blows);
    for (Blow const& blow : blows) lean_or_tell(context, substep, blow, time);
}

}  // namespace physics
