#include <algorithm>
#include <cmath>

#include "physics/exact.h"
#include "physics/steps_pairs.h"
#include "physics/steps_plan.h"

namespace physics {

using geometry::dot;
using geometry::length;

namespace {

constexpr int most_passes = 32;     // over all pairs in one substep
constexpr double unmoving = 1e-9;   // share of the speeds: slower closing is rounding
constexpr double soft_closing = 8;  // substeps' worth of what presses: leaning balls that close faster hit each other
constexpr double parted = 5e-3;     // share of the smaller radius: a gap at which balls no longer lean on each other

// The way of one ball since its last departure, as a chord.
Vec2 on_the_way(Stage const& stage, int ball, double time, double length_of_substep) {
    Departure const& from = stage.departures[ball];
    Vec2 const& to = stage.travellers[ball].state.position;
    double const span = length_of_substep - from.time;
    if (span <= 0) return to;
    return from.state.position + ((time - from.time) / span) * (to - from.state.position);
}

// When the two first touch on their chords, or `never`. Balls that overlap from the start touch then if they close,
// faster than `least`.
double touching_time(Stage const& stage, Neighbours const& e, double end, double least) {
    double const start = std::max(stage.departures[e.first].time, stage.departures[e.second].time);
    Vec2 const d0 = on_the_way(stage, e.second, start, end) - on_the_way(stage, e.first, start, end);
    Vec2 const d1 = stage.travellers[e.second].state.position - stage.travellers[e.first].state.position;
    double const reach = stage.travellers[e.first].ball->radius + stage.travellers[e.second].ball->radius;
    Vec2 const way = d1 - d0;
    double const a = dot(way, way), b = dot(d0, way);
    if (b >= 0 || -b <= least * (end - start) * length(d0)) return never;
    double const c = dot(d0, d0) - reach * reach;
    if (c <= 0) return start;
    double const square = b * b - a * c;
    if (square < 0) return never;
    double const share = c / (std::sqrt(square) - b);
    return share <= 1 ? start + share * (end - start) : never;
}

void forget_events(Trail<Event>& events, int ball, double from) {
    while (!events.empty() && events.back().ball == ball && events.back().kind != EventKind::hit &&
           events.back().time > from)
        events.pop_back();
    auto const late = [&](Event const& e) { return e.ball == ball && e.time > from && e.kind != EventKind::hit; };
    events.erase(std::remove_if(events.begin(), events.end(), late), events.end());
}

// Takes a ball back to `time` within the substep.
void go_back(Stage& stage, Substep const& substep, int ball, double time) {
    if (stage.asleep[ball]) return;
    if (is_stepped(stage.world, ball)) {
        stage.travellers[ball].state.position = on_the_way(stage, ball, time, substep.length);
        return;
    }
    forget_events(stage.history.events, ball, substep.since + stage.departures[ball].time);
    return_to_departure(stage, ball);
    follow(stage, ball, substep.since + time);
}

// On from the hit to the end of the substep.
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

double closing_of(Stage const& stage, Neighbours const& e) {
    State const& a = stage.travellers[e.first].state;
    State const& b = stage.travellers[e.second].state;
    Vec2 const d = b.position - a.position;
    double const distance = length(d);
    return distance > 0 ? -dot(b.velocity - a.velocity, d) / distance : 0;
}

// Both balls are where they touch. Answers whether anything happened.
void hit(Stage& stage, Substep const& substep, Neighbours& e, double time) {
    Traveller& a = stage.travellers[e.first];
    Traveller& b = stage.travellers[e.second];
    Vec2 const d = b.state.position - a.state.position;
    double const distance = length(d);
    Vec2 const normal = distance > 0 ? Vec2(d / distance) : Vec2(0, 1);
    double const pressing = pressing_on(stage, e, normal);
    double const restitution = restitution_between(*a.ball, *b.ball);
    double const closing = closing_of(stage, e);
    bool const bounces = restitution * closing > 2 * pressing * substep.length;
    PairImpact const impact = after_pair_impact(a.state, *a.ball, b.state, *b.ball, normal, bounces ? restitution : 0);
    a.state = impact.first;
    b.state = impact.second;
    if (!bounces && pressing > 0) {
        stage.regroup = stage.regroup || !e.leaning;
        e.leaning = true;
        stage.leaning[e.first] = stage.leaning[e.second] = 1;
    }
    if (closing > 2 * pressing * substep.length)
        stage.history.events.push_back({substep.since + time, EventKind::hit, e.first, a.state, no_contact, e.second});
}

// What a leaning pair carries in a substep, as the speed that it would give the lighter of the two, m/s.
double load_on(Stage const& stage, Neighbours const& e) {
    double const lighter = std::min(stage.travellers[e.first].ball->mass, stage.travellers[e.second].ball->mass);
    return e.impulse.normal / lighter;
}

// How fast a leaning pair may close before its balls hit each other: more for what it carries, as far as the heaviest
// ball outweighs the lightest. Among equals gravity alone counts; deep in a pile they would else pass through each
// other.
struct Softly {
    double fall = 0;      // m/s, of some substeps in free fall
    double outweigh = 0;  // how many times the heaviest is heavier than the lightest, less one
};

Softly softly_in(Stage const& stage, Substep const& substep) {
    auto const [lightest, heaviest] =
        std::minmax_element(stage.travellers.begin(), stage.travellers.end(),
                            [](Traveller const& a, Traveller const& b) { return a.ball->mass < b.ball->mass; });
    return {soft_closing * length(stage.travellers.front().field->gravity) * substep.length,
            heaviest->ball->mass / lightest->ball->mass - 1};
}

double soft_closing_of(Stage const& stage, Neighbours const& e, Softly const& soft) {
    return soft.fall + std::min(soft_closing * load_on(stage, e), soft.outweigh * soft.fall);
}

// Leaning balls take some closing on each other softly; others meet at once if they close at all.
bool collides(Stage& stage, Substep const& substep, Neighbours& e, Softly const& soft) {
    Traveller const& a = stage.travellers[e.first];
    Traveller const& b = stage.travellers[e.second];
    double const rounding = unmoving * (length(a.state.velocity) + length(b.state.velocity));
    double const least = e.leaning ? rounding + soft_closing_of(stage, e, soft) : rounding;
    if (e.leaning && closing_of(stage, e) <= least) return false;
    double const time = touching_time(stage, e, substep.length, least);
    if (time > substep.length) return false;
    go_back(stage, substep, e.first, time);
    go_back(stage, substep, e.second, time);
    bool const closes = closing_of(stage, e) > least;
    if (closes) hit(stage, substep, e, time);
    go_on(stage, substep, e.first, time);
    go_on(stage, substep, e.second, time);
    return closes;
}

// What is worth a closer look after the balls have moved.
struct Suspects {
    std::vector<int> colliding;
    std::vector<int> parting;
};

// A bound of the length that needs no root.
double most_length(Vec2 const& v) { return std::abs(v.x()) + std::abs(v.y()); }

// Whether the two are too far apart, for what they move in a substep and `fall` besides, to have met.
bool far_apart(Body const& a, Body const& b, Vec2 const& d, double pace, double fall) {
    double const moved = pace * (most_length(a.velocity) + most_length(b.velocity));
    double const reach = a.radius + b.radius + 4 * moved + fall;
    return dot(d, d) > reach * reach;
}

// Most pairs neither collide nor part: they are told from the rest by the least that need be read.
Suspects suspects_of(Stage const& stage, Substep const& substep, Softly const& soft) {
    Suspects suspects;
    double const fall = 4 * substep.length * substep.length * length(stage.travellers.front().field->gravity);
    for (int const k : stage.live) {
        Neighbours const& e = stage.neighbours[k];
        Body const& a = stage.pile.bodies[e.first + 1];
        Body const& b = stage.pile.bodies[e.second + 1];
        Vec2 const d = b.position - a.position;
        if (!e.leaning) {
            bool const pulled = e.first == stage.pulled || e.second == stage.pulled;
            if (pulled || !far_apart(a, b, d, substep.length, fall)) suspects.colliding.push_back(k);
            continue;
        }
        Vec2 const relative = b.velocity - a.velocity;
        if (dot(relative, relative) > soft.fall * soft.fall) suspects.colliding.push_back(k);
        double const reach = a.radius + b.radius + parted * std::min(a.radius, b.radius);
        if (dot(d, d) > reach * reach) suspects.parting.push_back(k);
    }
    return suspects;
}

void part(Stage& stage, std::vector<int> const& pairs) {
    for (int const k : pairs) {
        Neighbours& e = stage.neighbours[k];
        e.leaning = false;
        e.impulse = {};
        stage.asleep[e.first] = stage.asleep[e.second] = 0;
        stage.regroup = true;
    }
}

// For those that the pile has not moved itself, or not last.
void note_bodies(Stage& stage, std::vector<int> const& balls) {
    for (int const i : balls) {
        stage.pile.bodies[i + 1].position = stage.travellers[i].state.position;
        stage.pile.bodies[i + 1].velocity = stage.travellers[i].state.velocity;
    }
}

bool any_collides(Stage& stage, Substep const& substep, std::vector<int> const& pairs, Softly const& soft) {
    bool any = false;
    for (int const k : pairs) any = collides(stage, substep, stage.neighbours[k], soft) || any;
    return any;
}

// Those whose way is not what it was.
std::vector<int> struck_pairs(Stage& stage) {
    note_bodies(stage, stage.awake);
    find_more_neighbours(stage);
    if (stage.relist) group(stage);
    std::vector<int> struck;
    for (int const k : stage.live)
        if (stage.struck[stage.neighbours[k].first] || stage.struck[stage.neighbours[k].second]) struck.push_back(k);
    std::fill(stage.struck.begin(), stage.struck.end(), char{0});
    return struck;
}

}  // namespace

void collide(Stage& stage, Substep const& substep) {
    Softly const soft = softly_in(stage, substep);
    note_bodies(stage, stage.free);
    find_more_neighbours(stage);
    if (stage.relist) group(stage);
    Suspects suspects = suspects_of(stage, substep, soft);
    stage.struck.assign(stage.travellers.size(), 0);
    bool const any = any_collides(stage, substep, suspects.colliding, soft);
    for (int i = 1; i < most_passes && any; ++i)
        if (!any_collides(stage, substep, struck_pairs(stage), soft)) break;
    if (any) {
        if (stage.relist) group(stage);
        note_bodies(stage, stage.awake);
        suspects = suspects_of(stage, substep, soft);
    }
    part(stage, suspects.parting);
}

}  // namespace physics
