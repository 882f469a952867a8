#include <algorithm>
#include <cmath>

#include "physics/steps_firm.h"
#include "physics/steps_hit.h"
#include "physics/steps_pairs.h"
#include "physics/steps_plan.h"
#include "physics/steps_swell.h"

namespace physics {

using geometry::dot;
using geometry::length;

namespace {

constexpr int most_passes = 64;     // in one substep; balls that hit on after so many crowd
constexpr int refinements = 2;      // of a moment of touch
constexpr double together = 1e-9;   // share of a substep: hits nearer to each other in time are of one moment
constexpr double soft_closing = 8;  // substeps' worth of what presses: leaning balls that close faster hit each other
constexpr double parted = 5e-3;     // share of the smaller radius: a gap at which balls no longer lean on each other

// When two balls first touch on straight ways from `start` to `end`, or `never`. Balls that overlap from the start
// touch then if they close, faster than `least`.
double touching_on_chord(Vec2 const& d0, Vec2 const& d1, double reach, double start, double end, double least) {
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

// When one of the two next goes over to another leg, s into the substep, or its end.
double next_bend(Stage const& stage, Substep const& substep, Neighbours const& e, double from) {
    double bend = substep.length;
    for (int const ball : {e.first, e.second}) {
        if (is_stepped(stage.world, ball)) continue;
        Trail<Leg> const& legs = stage.history.legs[ball];
        for (auto leg = legs.end(); leg != legs.begin() && (leg - 1)->since > substep.since + from; --leg)
            bend = std::min(bend, (leg - 1)->since - substep.since);
    }
    return bend > from ? bend : substep.length;
}

// Two balls on their plans, near the moment found on chords: Newton's steps to the moment of their legs.
double refined(Stage const& stage, Substep const& substep, Neighbours const& e, double reach, double time) {
    for (int i = 0; i < refinements; ++i) {
        State const a = state_at(stage.history, e.first, substep.since + time);
        State const b = state_at(stage.history, e.second, substep.since + time);
        Vec2 const d = b.position - a.position;
        double const distance = length(d), rate = dot(b.velocity - a.velocity, d) / distance;
        if (!(rate < 0)) break;
        time = std::clamp(time - (distance - reach) / rate, 0.0, substep.length);
    }
    return time;
}

// The same on the ways of the substep, leg by leg.
double touching_time(Stage const& stage, Substep const& substep, Neighbours const& e, double least) {
    double const reach = stage.travellers[e.first].ball->radius + stage.travellers[e.second].ball->radius;
    bool const on_plans = !is_stepped(stage.world, e.first) && !is_stepped(stage.world, e.second);
    double const start = std::max(stage.departures[e.first].time, stage.departures[e.second].time), end = substep.length;
    auto const way_at = [&](double time) {
        return Vec2(on_the_way(stage, substep, e.second, time) - on_the_way(stage, substep, e.first, time));
    };
    Vec2 d = way_at(start);
    if (is_stepped(stage.world, e.first) && is_stepped(stage.world, e.second))
        return touching_on_chord(d, stage.travellers[e.second].state.position - stage.travellers[e.first].state.position,
                                 reach, start, end, least);
    for (double from = start; from < end;) {
        double const until = next_bend(stage, substep, e, from);
        Vec2 const then = way_at(until);
        double const time = touching_on_chord(d, then, reach, from, until, least);
        if (time == start) return time;
        if (time != never) return on_plans ? std::max(start, refined(stage, substep, e, reach, time)) : time;
        from = until;
        d = then;
    }
    return never;
}

// What a leaning pair carries in a substep, as the speed that it would give the lighter of the two, m/s.
double load_on(Stage const& stage, Neighbours const& e) {
    auto const mass = [&](int ball) { return stage.pile.swell[ball] * stage.travellers[ball].ball->mass; };
    return e.impulse.normal / std::min(mass(e.first), mass(e.second));
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
            std::min(most_outweigh, heaviest->ball->mass / lightest->ball->mass) - 1};
}

double soft_closing_of(Stage const& stage, Neighbours const& e, Softly const& soft) {
    return soft.fall + std::min(soft_closing * load_on(stage, e), soft.outweigh * soft.fall);
}

// Two balls that touch at a moment within the substep.
struct Touching {
    int pair = 0;
    double time = 0;   // s
    double least = 0;  // m/s: slower closing is none
};

// Leaning balls take some closing on each other softly; others meet at once if they close at all.
Touching touching_of(Stage const& stage, Substep const& substep, int pair, Softly const& soft) {
    Neighbours const& e = stage.neighbours[pair];
    Traveller const& a = stage.travellers[e.first];
    Traveller const& b = stage.travellers[e.second];
    double const rounding = unmoving * (length(a.state.velocity) + length(b.state.velocity));
    double const least = e.leaning ? rounding + soft_closing_of(stage, e, soft) : rounding;
    if (e.leaning && closing_of(stage, e) <= least) return {pair, never, least};
    return {pair, touching_time(stage, substep, e, least), least};
}

std::vector<Touching> touchings_of(Stage const& stage, Substep const& substep, std::vector<int> const& pairs,
                                   Softly const& soft) {
    std::vector<Touching> touchings;
    for (int const k : pairs) {
        Touching const touching = touching_of(stage, substep, k, soft);
        if (touching.time <= substep.length) touchings.push_back(touching);
    }
    return touchings;
}

// Parted so that those that share balls are in one bunch, in order.
std::vector<std::vector<Touching>> bunches_of(Stage const& stage, std::vector<Touching> const& due) {
    std::vector<std::vector<Touching>> bunches;
    std::vector<char> taken(due.size(), 0);
    auto const share = [&](Touching const& a, Touching const& b) {
        Neighbours const& e = stage.neighbours[a.pair];
        Neighbours const& f = stage.neighbours[b.pair];
        return e.first == f.first || e.first == f.second || e.second == f.first || e.second == f.second;
    };
    for (std::size_t i = 0; i < due.size(); ++i) {
        if (taken[i]) continue;
        std::vector<Touching> bunch{due[i]};
        for (std::size_t n = 0; n < bunch.size(); ++n)
            for (std::size_t j = i + 1; j < due.size(); ++j) {
                if (taken[j] || !share(bunch[n], due[j])) continue;
                taken[j] = 1;
                bunch.push_back(due[j]);
            }
        bunches.push_back(bunch);
    }
    return bunches;
}

// Takes those out that come before all others of their balls, to rounding; those of one moment that share balls one
// after the other, by bunches.
std::vector<std::vector<Touching>> taken_due(Stage& stage, std::vector<Touching>& touchings, double moment) {
    std::vector<double>& soonest = stage.soonest;
    soonest.resize(stage.travellers.size(), never);
    auto const each_ball = [&](auto const& visit) {
        for (Touching const& touching : touchings)
            for (int const ball : {stage.neighbours[touching.pair].first, stage.neighbours[touching.pair].second})
                visit(touching, soonest[ball]);
    };
    each_ball([](Touching const& touching, double& time) { time = std::min(time, touching.time); });
    auto const is_due = [&](Touching const& touching) {
        Neighbours const& e = stage.neighbours[touching.pair];
        return touching.time <= std::min(soonest[e.first], soonest[e.second]) + moment;
    };
    auto const rest = std::stable_partition(touchings.begin(), touchings.end(), is_due);
    std::vector<Touching> const due(touchings.begin(), rest);
    each_ball([](Touching const&, double& time) { time = never; });
    touchings.erase(touchings.begin(), rest);
    return bunches_of(stage, due);
}

// Those of one moment that share balls hit together. Answers whether any does.
bool strike_bunch(Stage& stage, Substep const& substep, std::vector<Touching> const& bunch) {
    double time = never;
    std::vector<int> balls;
    for (Touching const& touching : bunch) {
        Neighbours const& e = stage.neighbours[touching.pair];
        time = std::min(time, touching.time);
        for (int const ball : {e.first, e.second})
            if (std::find(balls.begin(), balls.end(), ball) == balls.end()) balls.push_back(ball);
    }
    for (int const ball : balls) go_back(stage, substep, ball, std::max(time, stage.departures[ball].time));
    std::vector<int> closing;
    for (Touching const& touching : bunch)
        if (closing_of(stage, stage.neighbours[touching.pair]) > touching.least) closing.push_back(touching.pair);
    if (!closing.empty()) hit(stage, substep, closing, time);
    for (int const ball : balls) go_on(stage, substep, ball, std::max(time, stage.departures[ball].time));
    return !closing.empty();
}

// What is worth a closer look after the balls have moved.
struct Suspects {
    std::vector<int> colliding;
    std::vector<int> parting;
    std::vector<int> deep;  // overlap too far
};

// A bound of the length that needs no root.
double most_length(Vec2 const& v) { return std::abs(v.x()) + std::abs(v.y()); }

// Whether the two are too far apart, for what they move in a substep and `fall` besides, to have met.
bool far_apart(Body const& a, Body const& b, Vec2 const& d, double pace, double fall) {
    double const moved = pace * (most_length(a.velocity) + most_length(b.velocity));
    double const reach = a.radius + b.radius + 4 * moved + fall;
    return dot(d, d) > reach * reach;
}

bool overlap_deep(Body const& a, Body const& b, Vec2 const& d) {
    double const least = a.radius + b.radius - too_deep * std::min(a.radius, b.radius);
    return dot(d, d) < least * least;
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
            if (!pulled && far_apart(a, b, d, substep.length, fall)) continue;
            suspects.colliding.push_back(k);
            if (overlap_deep(a, b, d)) suspects.deep.push_back(k);
            continue;
        }
        Vec2 const relative = b.velocity - a.velocity;
        if (dot(relative, relative) > soft.fall * soft.fall) suspects.colliding.push_back(k);
        double const reach = a.radius + b.radius + parted * std::min(a.radius, b.radius);
        if (dot(d, d) > reach * reach) suspects.parting.push_back(k);
        if (overlap_deep(a, b, d)) suspects.deep.push_back(k);
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

// By ball, which of the live pairs it is in.
void list_pairs_of_balls(Stage& stage) {
    stage.pairs_from.assign(stage.travellers.size() + 1, 0);
    for (int const k : stage.live) {
        ++stage.pairs_from[stage.neighbours[k].first];
        ++stage.pairs_from[stage.neighbours[k].second];
    }
    for (std::size_t i = 1; i < stage.pairs_from.size(); ++i) stage.pairs_from[i] += stage.pairs_from[i - 1];
    stage.pairs_of.resize(2 * stage.live.size());
    for (int const k : stage.live)
        for (int const ball : {stage.neighbours[k].first, stage.neighbours[k].second})
            stage.pairs_of[--stage.pairs_from[ball]] = k;
}

// Those whose way is not what it was.
std::vector<int> struck_pairs(Stage& stage) {
    std::vector<int> balls;
    for (std::size_t i = 0; i < stage.struck.size(); ++i)
        if (stage.struck[i]) balls.push_back(static_cast<int>(i));
    note_bodies(stage, balls);
    find_more_neighbours(stage, balls);
    if (stage.relist) {
        group(stage);
        stage.pairs_of.clear();
    }
    if (stage.pairs_of.empty()) list_pairs_of_balls(stage);
    std::vector<int> struck;
    for (int const ball : balls) {
        struck.insert(struck.end(), stage.pairs_of.begin() + stage.pairs_from[ball],
                      stage.pairs_of.begin() + stage.pairs_from[ball + 1]);
        stage.struck[ball] = 0;
    }
    std::sort(struck.begin(), struck.end());
    struck.erase(std::unique(struck.begin(), struck.end()), struck.end());
    return struck;
}

// Whether the pull on a leaning ball is more than soft contacts hold even for one substep.
bool pulled_hard(Stage const& stage, Substep const& substep) {
    if (stage.pulled < 0 || !stage.leaning[stage.pulled]) return false;
    Traveller const& traveller = stage.travellers[stage.pulled];
    double const pull = length(acceleration_in(*traveller.field, traveller.state.position, Vec2::Zero()));
    return pull * substep.length * substep.length > 0.1 * deepest * traveller.ball->radius;
}

// Pass by pass, in each those that come first for their balls: so that neither the order of pairs nor that of balls
// decides. Answers whether there was any hit.
bool hit_all(Stage& stage, Substep const& substep, std::vector<int> pairs, Softly const& soft) {
    bool any = false;
    stage.pairs_of.clear();
    for (int pass = 0; pass < most_passes; ++pass) {
        std::vector<Touching> touchings = touchings_of(stage, substep, pairs, soft);
        if (touchings.empty()) return any;
        bool hits = false;
        for (std::vector<Touching> const& bunch : taken_due(stage, touchings, together * substep.length))
            hits = strike_bunch(stage, substep, bunch) || hits;
        any = any || hits;
        if (!hits) return any;
        for (Touching const& waiting : touchings)
            stage.struck[stage.neighbours[waiting.pair].first] = stage.struck[stage.neighbours[waiting.pair].second] =
                1;
        pairs = struck_pairs(stage);
    }
    std::vector<Touching> const crowding = touchings_of(stage, substep, pairs, soft);
    for (Touching const& touching : crowding)
        if (touching_of(stage, substep, touching.pair, soft).time <= substep.length)
            stop_crowd(stage, substep, touching.pair, touching.time);
    struck_pairs(stage);
    return any;
}

}  // namespace

void collide(Stage& stage, Substep const& substep) {
    Softly const soft = softly_in(stage, substep);
    note_bodies(stage, stage.free);
    find_more_neighbours(stage, stage.awake);
    if (stage.relist) group(stage);
    Suspects suspects = suspects_of(stage, substep, soft);
    stage.struck.assign(stage.travellers.size(), 0);
    if (hit_all(stage, substep, suspects.colliding, soft)) {
        if (stage.relist) group(stage);
        note_bodies(stage, stage.awake);
        suspects = suspects_of(stage, substep, soft);
    }
    part(stage, suspects.parting);
    for (int const k : suspects.deep) part_deep(stage, substep, stage.neighbours[k].first, stage.neighbours[k].second);
    for (int const ball : stage.pile.deep) part_deep(stage, substep, ball, ball);
    if (pulled_hard(stage, substep)) part_deep(stage, substep, stage.pulled, stage.pulled);
}

}  // namespace physics
