#include "physics/steps/collide.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "physics/steps/firm_contacts.h"
#include "physics/steps/hits.h"
#include "physics/steps/broadphase.h"
#include "physics/steps/lone_balls.h"
#include "physics/steps/mass_scaling.h"
#include "physics/steps/time_of_touch.h"

namespace physics {

using geometry::dot;
using geometry::length;

namespace {

constexpr int most_passes = 64;     // in one substep; balls that hit on after so many crowd
constexpr double together = 1e-9;   // share of a substep: hits nearer to each other in time are of one moment
constexpr double soft_closing = 8;  // substeps' worth of what presses: leaning balls that close faster hit each other
constexpr double parted = 5e-3;     // share of the smaller radius: a gap at which balls no longer lean on each other

// What a leaning pair carries in a substep, as the speed that it would give the lighter of the two, m/s.
double load_on(StepContext const& context, BallPair const& e) {
    auto const mass = [&](int ball) { return context.island.swell[ball] * context.body_states[ball].ball->mass; };
    return e.impulse.normal / std::min(mass(e.first), mass(e.second));
}

// How fast a leaning pair may close before its balls hit each other: more for what it carries, as far as the heaviest
// ball outweighs the lightest. Among equals gravity alone counts; deep in a pile they would else pass through each
// other.
struct Softly {
    double fall = 0;      // m/s, of some substeps in free fall
    double outweigh = 0;  // how many times the heaviest is heavier than the lightest, less one
};

Softly softly_in(StepContext const& context, Substep const& substep) {
    return {soft_closing * length(context.body_states.front().field->gravity) * substep.length,
            std::min(most_outweigh, context.mass_ratio) - 1};
}

double soft_closing_of(StepContext const& context, BallPair const& e, Softly const& soft) {
    return soft.fall + std::min(soft_closing * load_on(context, e), soft.outweigh * soft.fall);
}

// Two balls that touch at a moment within the substep.
struct Touching {
    int pair = 0;
    double time = 0;   // s
    double least = 0;  // m/s: slower closing is none
};

// Leaning balls take some closing on each other softly; others meet at once if they close at all.
Touching touching_of(StepContext const& context, Substep const& substep, int pair, Softly const& soft) {
    BallPair const& e = context.ball_pairs[pair];
    BodyState const& a = context.body_states[e.first];
    BodyState const& b = context.body_states[e.second];
    if (e.leaning) {
        Vec2 const relative = b.state.velocity - a.state.velocity;
        if (dot(relative, relative) <= soft.fall * soft.fall) return {pair, never, soft.fall};
        if (dot(relative, b.state.position - a.state.position) >= 0) return {pair, never, 0};
    }
    double const rounding = unmoving * (length(a.state.velocity) + length(b.state.velocity));
    double const least = e.leaning ? rounding + soft_closing_of(context, e, soft) : rounding;
    if (e.leaning && closing_of(context, e) <= least) return {pair, never, least};
    return {pair, time_of_touch(context, substep, e, least), least};
}

std::vector<Touching> touchings_of(StepContext const& context, Substep const& substep, std::vector<int> const& pairs,
                                   Softly const& soft) {
    std::vector<Touching> touchings;
    for (int const k : pairs) {
        Touching const touching = touching_of(context, substep, k, soft);
        if (touching.time <= substep.length) touchings.push_back(touching);
    }
    return touchings;
}

// Touchings of one moment, in bunches of so many.
struct Bunches {
    std::vector<Touching> touchings;
    std::vector<std::size_t> sizes;
};

// Those that share balls are brought together: whoever shares one with the first of a bunch comes next, in order, and
// so on; the others keep theirs.
Bunches bunches_of(StepContext const& context, std::vector<Touching> due) {
    Bunches bunches;
    auto const share = [&](Touching const& a, Touching const& b) {
        BallPair const& e = context.ball_pairs[a.pair];
        BallPair const& f = context.ball_pairs[b.pair];
        return e.first == f.first || e.first == f.second || e.second == f.first || e.second == f.second;
    };
    for (auto begin = due.begin(), end = begin; begin != due.end(); begin = end) {
        ++end;
        for (auto member = begin; member != end; ++member)
            for (auto other = end; other != due.end(); ++other)
                if (share(*member, *other)) std::rotate(end++, other, other + 1);
        bunches.sizes.push_back(static_cast<std::size_t>(end - begin));
    }
    bunches.touchings = std::move(due);
    return bunches;
}

// Takes those out that come before all others of their balls, to rounding; those of one moment that share balls one
// after the other, by bunches.
Bunches taken_due(StepContext& context, std::vector<Touching>& touchings, double moment) {
    std::vector<double>& soonest = context.soonest;
    soonest.resize(context.body_states.size(), never);
    auto const each_ball = [&](auto const& visit) {
        for (Touching const& touching : touchings)
            for (int const ball : {context.ball_pairs[touching.pair].first, context.ball_pairs[touching.pair].second})
                visit(touching, soonest[ball]);
    };
    each_ball([](Touching const& touching, double& time) { time = std::min(time, touching.time); });
    auto const is_due = [&](Touching const& touching) {
        BallPair const& e = context.ball_pairs[touching.pair];
        return touching.time <= std::min(soonest[e.first], soonest[e.second]) + moment;
    };
    auto const rest = std::stable_partition(touchings.begin(), touchings.end(), is_due);
    std::vector<Touching> due(touchings.begin(), rest);
    each_ball([](Touching const&, double& time) { time = never; });
    touchings.erase(touchings.begin(), rest);
    return bunches_of(context, std::move(due));
}

// Those of one moment that share balls hit together. Answers whether any does.
bool strike_bunch(StepContext& context, Substep const& substep, std::span<Touching const> bunch) {
    double time = never;
    std::vector<int>&balls = context.bunch_balls, &closing = context.bunch_pairs;
    balls.clear();
    closing.clear();
    for (Touching const& touching : bunch) {
        BallPair const& e = context.ball_pairs[touching.pair];
        time = std::min(time, touching.time);
        for (int const ball : {e.first, e.second})
            if (std::find(balls.begin(), balls.end(), ball) == balls.end()) balls.push_back(ball);
    }
    for (int const ball : balls) go_back(context, substep, ball, std::max(time, context.departures[ball].time));
    for (Touching const& touching : bunch)
        if (closing_of(context, context.ball_pairs[touching.pair]) > touching.least) closing.push_back(touching.pair);
    if (!closing.empty()) hit(context, substep, closing, time);
    for (int const ball : balls) go_on(context, substep, ball, std::max(time, context.departures[ball].time));
    return !closing.empty();
}

// What is worth a closer look after the balls have moved.
struct CandidatePairs {
    std::vector<int> colliding;
    std::vector<int> parting;
    std::vector<int> deep;  // overlap too far
};

// A bound of the length that needs no root.
double most_length(Vec2 const& v) { return std::abs(v.x()) + std::abs(v.y()); }

// Whether the two are too far apart, for what they move in a substep and `fall` besides, to have met.
bool far_apart(SolverBody const& a, SolverBody const& b, Vec2 const& d, double pace, double fall) {
    double const moved = pace * (most_length(a.velocity) + most_length(b.velocity));
    double const reach = a.radius + b.radius + 4 * moved + fall;
    return dot(d, d) > reach * reach;
}

bool overlap_deep(SolverBody const& a, SolverBody const& b, Vec2 const& d) {
    double const least = a.radius + b.radius - too_deep * std::min(a.radius, b.radius);
    return dot(d, d) < least * least;
}

// Most pairs neither collide nor part: they are told from the rest by the least that need be read.
CandidatePairs suspects_of(StepContext const& context, Substep const& substep, Softly const& soft) {
    CandidatePairs candidates;
    double const fall = 4 * substep.length * substep.length * length(context.body_states.front().field->gravity);
    for (int const k : context.live) {
        BallPair const& e = context.ball_pairs[k];
        SolverBody const& a = context.island.bodies[e.first + 1];
        SolverBody const& b = context.island.bodies[e.second + 1];
        Vec2 const d = b.position - a.position;
        if (!e.leaning) {
            bool const pulled = e.first == context.pulled || e.second == context.pulled;
            if (!pulled && far_apart(a, b, d, substep.length, fall)) continue;
            candidates.colliding.push_back(k);
            if (overlap_deep(a, b, d)) candidates.deep.push_back(k);
            continue;
        }
        Vec2 const relative = b.velocity - a.velocity;
        if (dot(relative, relative) > soft.fall * soft.fall) candidates.colliding.push_back(k);
        double const reach = a.radius + b.radius + parted * std::min(a.radius, b.radius);
        if (dot(d, d) > reach * reach) candidates.parting.push_back(k);
        if (overlap_deep(a, b, d)) candidates.deep.push_back(k);
    }
    return candidates;
}

void part(StepContext& context, std::vector<int> const& pairs) {
    for (int const k : pairs) {
        BallPair& e = context.ball_pairs[k];
        e.leaning = false;
        e.impulse = {};
        context.asleep[e.first] = context.asleep[e.second] = 0;
        context.regroup = true;
    }
}

// For those that the pile has not moved itself, or not last.
void note_bodies(StepContext& context, std::vector<int> const& balls) {
    for (int const i : balls) {
        context.island.bodies[i + 1].position = context.body_states[i].state.position;
        context.island.bodies[i + 1].velocity = context.body_states[i].state.velocity;
    }
}

// By ball, which of the live pairs it is in, in order.
void list_pairs_of_balls(StepContext& context) {
    context.pairs_from.assign(context.body_states.size() + 1, 0);
    for (int const k : context.live) {
        ++context.pairs_from[context.ball_pairs[k].first];
        ++context.pairs_from[context.ball_pairs[k].second];
    }
    for (std::size_t i = 1; i < context.pairs_from.size(); ++i) context.pairs_from[i] += context.pairs_from[i - 1];
    context.pairs_of.resize(2 * context.live.size());
    for (auto k = context.live.rbegin(); k != context.live.rend(); ++k)
        for (int const ball : {context.ball_pairs[*k].first, context.ball_pairs[*k].second})
            context.pairs_of[--context.pairs_from[ball]] = *k;
}

// Those whose way is not what it was, in order.
void find_struck_pairs(StepContext& context, std::vector<int>& pairs) {
    std::vector<int>& balls = context.struck_balls;
    std::sort(balls.begin(), balls.end());
    note_bodies(context, balls);
    find_more_neighbours(context, balls);
    if (context.relist) group(context);
    if (context.pairs_of.empty()) list_pairs_of_balls(context);
    pairs.clear();
    for (bool const as_first : {true, false}) {  // pairs are in order of the first ball
        auto const before = static_cast<std::ptrdiff_t>(pairs.size());
        for (int const ball : balls)
            for (int i = context.pairs_from[ball]; i < context.pairs_from[ball + 1]; ++i) {
                int const first = context.ball_pairs[context.pairs_of[i]].first;
                if (as_first ? first == ball : first != ball && !context.struck[first])
                    pairs.push_back(context.pairs_of[i]);
            }
        if (as_first) continue;
        std::sort(pairs.begin() + before, pairs.end());
        std::inplace_merge(pairs.begin(), pairs.begin() + before, pairs.end());
    }
    for (int const ball : balls) context.struck[ball] = 0;
    balls.clear();
}

// Whether the pull on a leaning ball is more than soft contacts hold even for one substep.
bool pulled_hard(StepContext const& context, Substep const& substep) {
    if (context.pulled < 0 || !context.leaning[context.pulled]) return false;
    BodyState const& body_state = context.body_states[context.pulled];
    double const pull = length(acceleration_in(*body_state.field, body_state.state.position, Vec2::Zero()));
    return pull * substep.length * substep.length > 0.1 * deepest * body_state.ball->radius;
}

// Pass by pass, in each those that come first for their balls: so that neither the order of pairs nor that of balls
// decides. Answers whether there was any hit.
bool hit_all(StepContext& context, Substep const& substep, std::vector<int> pairs, Softly const& soft) {
    bool any = false;
    for (int pass = 0; pass < most_passes; ++pass) {
        std::vector<Touching> touchings = touchings_of(context, substep, pairs, soft);
        if (touchings.empty()) return any;
        bool hits = false;
        Bunches const bunches = taken_due(context, touchings, together * substep.length);
        auto begin = bunches.touchings.begin();
        for (std::size_t const size : bunches.sizes) {
            hits = strike_bunch(context, substep, {begin, size}) || hits;
            begin += static_cast<std::ptrdiff_t>(size);
        }
        any = any || hits;
        if (!hits) return any;
        for (Touching const& waiting : touchings)
            for (int const ball : {context.ball_pairs[waiting.pair].first, context.ball_pairs[waiting.pair].second})
                mark_struck(context, ball);
        find_struck_pairs(context, pairs);
    }
    std::vector<Touching> const crowding = touchings_of(context, substep, pairs, soft);
    for (Touching const& touching : crowding)
        if (touching_of(context, substep, touching.pair, soft).time <= substep.length)
            stop_crowd(context, substep, touching.pair, touching.time);
    find_struck_pairs(context, pairs);
    return any;
}

}  // namespace

void collide(StepContext& context, Substep const& substep) {
    Softly const soft = softly_in(context, substep);
    note_bodies(context, context.free);
    find_more_neighbours(context, context.awake);
    if (context.relist) group(context);
    CandidatePairs candidates = suspects_of(context, substep, soft);
    context.struck.assign(context.body_states.size(), 0);
    context.struck_balls.clear();
    if (hit_all(context, substep, candidates.colliding, soft)) {
        if (context.relist) group(context);
        note_bodies(context, context.awake);
        candidates = suspects_of(context, substep, soft);
    }
    part(context, candidates.parting);
    for (int const k : candidates.deep)
        part_deep(context, substep, context.ball_pairs[k].first, context.ball_pairs[k].second);
    for (int const ball : context.island.deep) part_deep(context, substep, ball, ball);
    if (pulled_hard(context, substep)) part_deep(context, substep, context.pulled, context.pulled);
}

}  // namespace physics
