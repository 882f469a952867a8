#include "physics/steps_hit.h"

#include <algorithm>
#include <cmath>

#include "physics/exact.h"
#include "physics/steps_plan.h"
#include "physics/steps_together.h"

namespace physics {

using geometry::dot;
using geometry::length;

namespace {

void forget_events(Trail<Event>& events, int ball, double from) {
    while (!events.empty() && events.back().ball == ball && events.back().kind != EventKind::hit &&
           events.back().time > from)
        events.pop_back();
    auto const late = [&](Event const& e) { return e.ball == ball && e.time > from && e.kind != EventKind::hit; };
    events.erase(std::remove_if(events.begin(), events.end(), late), events.end());
}

// How hard two touching balls are pressed together by what acts on them, as far as it can be told: two in free flight
// fall alike, but ground beneath one, or a third ball, may hold it against the other.
double pressing_on(Stage const& stage, Neighbours const& e, Vec2 const& normal) {
    Traveller const& a = stage.travellers[e.first];
    Traveller const& b = stage.travellers[e.second];
    Vec2 const pull_a = acceleration_in(*a.field, a.state.position, a.state.velocity);
    Vec2 const pull_b = acceleration_in(*b.field, b.state.position, b.state.velocity);
    bool const held =
        a.contact.feature >= 0 || b.contact.feature >= 0 || stage.leaning[e.first] || stage.leaning[e.second];
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

Blow blow_between(Stage const& stage, Substep const& substep, int pair) {
    Neighbours const& e = stage.neighbours[pair];
    Traveller const& a = stage.travellers[e.first];
    Traveller const& b = stage.travellers[e.second];
    Vec2 const d = b.state.position - a.state.position;
    double const distance = length(d);
    Blow blow;
    blow.pair = pair;
    blow.normal = distance > 0 ? Vec2(d / distance) : Vec2(0, 1);
    blow.pressing = pressing_on(stage, e, blow.normal);
    blow.closing = closing_of(stage, e);
    double const restitution = restitution_between(*a.ball, *b.ball);
    blow.bounces = restitution * blow.closing > 2 * blow.pressing * substep.length;
    blow.restitution = blow.bounces ? restitution : 0;
    return blow;
}

std::vector<ContactPush> pushes_of(Stage const& stage, std::vector<Blow> const& blows) {
    std::vector<ContactPush> pushes;
    for (Blow const& blow : blows) {
        Neighbours const& e = stage.neighbours[blow.pair];
        pushes.push_back({e.first, e.second, blow.normal, 1 / stage.travellers[e.first].ball->mass,
                          1 / stage.travellers[e.second].ball->mass, (1 + blow.restitution) * blow.closing});
    }
    return pushes;
}

void add_impulse(Traveller& traveller, Vec2 const& impulse, double tangent) {
    Ball const& ball = *traveller.ball;
    traveller.state.velocity += impulse / ball.mass;
    traveller.state.spin += tangent / (ball.inertia * ball.mass * ball.radius);
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
void rub_together(Stage& stage, std::vector<ContactPush> const& pushes, std::vector<double> const& normals) {
    std::vector<double> tangents;
    for (std::size_t i = 0; i < pushes.size(); ++i) {
        ContactPush const& push = pushes[i];
        Traveller const& a = stage.travellers[push.first];
        Traveller const& b = stage.travellers[push.second];
        double const slip = dot(b.state.velocity - a.state.velocity, geometry::turned_right(push.normal)) +
                            a.ball->radius * a.state.spin + b.ball->radius * b.state.spin;
        double const yield =
            (1 + 1 / a.ball->inertia) * push.first_yield + (1 + 1 / b.ball->inertia) * push.second_yield;
        double const grip = normals[i] > 0 ? friction_between(*a.ball, *b.ball) * normals[i] : 0;
        tangents.push_back(std::clamp(-slip / (yield * crowd_of(pushes, push)), -grip, grip));
    }
    for (std::size_t i = 0; i < pushes.size(); ++i) {
        Vec2 const impulse = tangents[i] * geometry::turned_right(pushes[i].normal);
        add_impulse(stage.travellers[pushes[i].first], -impulse, tangents[i]);
        add_impulse(stage.travellers[pushes[i].second], impulse, tangents[i]);
    }
}

void strike_together(Stage& stage, std::vector<Blow> const& blows) {
    std::vector<ContactPush> const pushes = pushes_of(stage, blows);
    std::vector<double> const normals = least_pushes(pushes);
    for (std::size_t i = 0; i < pushes.size(); ++i) {
        Vec2 const impulse = normals[i] * pushes[i].normal;
        add_impulse(stage.travellers[pushes[i].first], -impulse, 0);
        add_impulse(stage.travellers[pushes[i].second], impulse, 0);
    }
    rub_together(stage, pushes, normals);
}

void strike(Stage& stage, Blow const& blow) {
    Neighbours const& e = stage.neighbours[blow.pair];
    Traveller& a = stage.travellers[e.first];
    Traveller& b = stage.travellers[e.second];
    PairImpact const impact = after_pair_impact(a.state, *a.ball, b.state, *b.ball, blow.normal, blow.restitution);
    a.state = impact.first;
    b.state = impact.second;
}

}  // namespace

Vec2 on_the_way(Stage const& stage, Substep const& substep, int ball, double time) {
    if (!is_stepped(stage.world, ball)) return state_at(stage.history, ball, substep.since + time).position;
    Departure const& from = stage.departures[ball];
    Vec2 const& to = stage.travellers[ball].state.position;
    double const span = substep.length - from.time;
    return span > 0 ? Vec2(from.state.position + ((time - from.time) / span) * (to - from.state.position)) : to;
}

double closing_of(Stage const& stage, Neighbours const& e) {
    State const& a = stage.travellers[e.first].state;
    State const& b = stage.travellers[e.second].state;
    Vec2 const d = b.position - a.position;
    double const distance = length(d);
    return distance > 0 ? -dot(b.velocity - a.velocity, d) / distance : 0;
}

void go_back(Stage& stage, Substep const& substep, int ball, double time) {
    if (stage.asleep[ball]) return;
    if (is_stepped(stage.world, ball)) {
        stage.travellers[ball].state.position = on_the_way(stage, substep, ball, time);
        return;
    }
    forget_events(stage.history.events, ball, substep.since + stage.departures[ball].time);
    return_to_departure(stage, ball);
    follow(stage, ball, substep.since + time);
}

void go_on(Stage& stage, Substep const& substep, int ball, double time) {
    double const now = substep.since + time;
    if (stage.asleep[ball]) stage.regroup = stage.relist = true;
    stage.asleep[ball] = 0;
    stage.struck[ball] = 1;
    stage.travellers[ball].still = false;
    if (stage.leaning[ball]) {
        if (!is_stepped(stage.world, ball)) begin_chord(stage, ball, now);
        depart(stage, ball, time);
        sweep(stage, ball, now, substep.length - time);
    } else {
        strike(stage.scene, stage.world, stage.history, ball, stage.travellers[ball].state, now);
        follow(stage, ball, now);
        depart(stage, ball, time);
        follow(stage, ball, substep.end());
    }
}

void hit(Stage& stage, Substep const& substep, std::vector<int> const& pairs, double time) {
    std::vector<Blow> blows;
    for (int const k : pairs) blows.push_back(blow_between(stage, substep, k));
    if (blows.size() == 1)
        strike(stage, blows.front());
    else
        strike_together(stage, blows);
    for (Blow const& blow : blows) {
        Neighbours& e = stage.neighbours[blow.pair];
        if (!blow.bounces && blow.pressing > 0) {
            stage.regroup = stage.regroup || !e.leaning;
            e.leaning = true;
            stage.leaning[e.first] = stage.leaning[e.second] = 1;
        }
        if (blow.closing > 2 * blow.pressing * substep.length)
            stage.history.events.push_back(
                {substep.since + time, EventKind::hit, e.first, stage.travellers[e.first].state, no_contact, e.second});
    }
}

}  // namespace physics
