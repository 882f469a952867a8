#include "physics/steps/time_of_touch.h"

#include <algorithm>
#include <cmath>

#include "physics/steps/hits.h"

namespace physics {

using geometry::dot;
using geometry::length;

namespace {

constexpr int refinements = 2;  // of a moment of touch

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
double next_bend(StepContext const& context, Substep const& substep, BallPair const& e, double from) {
    double bend = substep.length;
    for (int const ball : {e.first, e.second}) {
        if (is_stepped(context.world, ball)) continue;
        Trail<Leg> const& legs = context.history.legs[ball];
        for (auto leg = legs.end(); leg != legs.begin() && (leg - 1)->since > substep.since + from; --leg)
            bend = std::min(bend, (leg - 1)->since - substep.since);
    }
    return bend > from ? bend : substep.length;
}

// Two balls on their plans, near the moment found on chords: Newton's steps to the moment of their legs.
double refined(StepContext const& context, Substep const& substep, BallPair const& e, double reach, double time) {
    for (int i = 0; i < refinements; ++i) {
        State const a = state_at(context.history, e.first, substep.since + time);
        State const b = state_at(context.history, e.second, substep.since + time);
        Vec2 const d = b.position - a.position;
        double const distance = length(d), rate = dot(b.velocity - a.velocity, d) / distance;
        if (!(rate < 0)) break;
        time = std::clamp(time - (distance - reach) / rate, 0.0, substep.length);
    }
    return time;
}

}  // namespace

double time_of_touch(StepContext const& context, Substep const& substep, BallPair const& e, double least) {
    double const reach = context.body_states[e.first].ball->radius + context.body_states[e.second].ball->radius;
    bool const on_plans = !is_stepped(context.world, e.first) && !is_stepped(context.world, e.second);
    double const start = std::max(context.departures[e.first].time, context.departures[e.second].time),
                 end = substep.length;
    auto const way_at = [&](double time) {
        return Vec2(on_the_way(context, substep, e.second, time) - on_the_way(context, substep, e.first, time));
    };
    Vec2 d = way_at(start);
    if (is_stepped(context.world, e.first) && is_stepped(context.world, e.second))
        return touching_on_chord(
            d, context.body_states[e.second].state.position - context.body_states[e.first].state.position, reach, start,
            end, least);
    for (double from = start; from < end;) {
        double const until = next_bend(context, substep, e, from);
        Vec2 const then = way_at(until);
        double const time = touching_on_chord(d, then, reach, from, until, least);
        if (time == start) return time;
        if (time != never) return on_plans ? std::max(start, refined(context, substep, e, reach, time)) : time;
        from = until;
        d = then;
    }
    return never;
}

}  // namespace physics
