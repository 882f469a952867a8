#include "physics/exact/time_of_impact.h"

#include <algorithm>
#include <cmath>

#include "geometry/polynomial.h"
#include "physics/plan/leg_plan.h"
#include "physics/motion/impact.h"

namespace physics {

using geometry::dot;

namespace {

constexpr double longest_search = 1;     // s, conservative advancement looks this far at a time
constexpr double gap_accuracy = 1e-13;   // m
constexpr double blink = 1e-6;           // s, over which a touch without pressure stays one
constexpr double glimpse = 1e-8;         // s, in which no ball bends back by more than gap_accuracy
constexpr double rate_rounding = 1e-12;  // share of the speeds below which a rate of approach is rounding
constexpr int advancement_cap = 4000;
constexpr int blow_sweeps = 2000;        // Gauss-Seidel sweeps over the pairs of one batch
constexpr double blow_accuracy = 1e-16;  // of the fastest approach

struct Approach {
    double gap = 0;   // m
    double rate = 0;  // m/s
};

Approach approach_at(Leg const& a, Leg const& b, double reach, double t) {
    State const sa = at(a, t), sb = at(b, t);
    Vec2 const way = sb.position - sa.position;
    double const distance = geometry::length(way);
    return {distance - reach, dot(way, sb.velocity - sa.velocity) / distance};
}

TimeOfImpact quadratic_encounter(Leg const& a, Leg const& b, double reach, double from, double until) {
    State const sa = at(a, from), sb = at(b, from);
    Vec2 const p = sb.position - sa.position, v = sb.velocity - sa.velocity;
    Vec2 const acceleration = std::get<Ballistic>(b.motion).acceleration - std::get<Ballistic>(a.motion).acceleration;
    auto gap = geometry::distance_quartic(p, v, acceleration, reach);
    double const speeds = geometry::length(sa.velocity) + geometry::length(sb.velocity);
    if (std::abs(gap[0]) <= 2 * reach * touch_reach) {
        gap[0] = 0;
        if (std::abs(gap[1]) <= 2 * reach * rate_rounding * speeds) gap[1] = 0;
        double const rounding = rate_rounding * (speeds * speeds + reach * geometry::length(acceleration));
        if (gap[1] == 0 && gap[2] < -rounding) return {from, true, true};
        if (gap[1] == 0 && gap[2] <= rounding) return {until, false, false};
    }
    auto const t = geometry::first_fall(gap, until - from);
    return t ? TimeOfImpact{from + *t, true, false} : TimeOfImpact{until, false, false};
}

double open_time(double gap, double rate, double bound) {
    double const root = std::sqrt(rate * rate + 2 * bound * gap);
    if (rate >= 0) return bound > 0 ? (rate + root) / bound : never;
    return 2 * gap / (root - rate);
}

TimeOfImpact advanced_encounter(Leg const& a, Leg const& b, double reach, double from, double until) {
    double const end = std::min(until, from + longest_search);
    double const bound = acceleration_bound(a, from, end) + acceleration_bound(b, from, end);
    double t = from;
    for (int i = 0; i < advancement_cap && t < end; ++i) {
        Approach const now = approach_at(a, b, reach, t);
        double const speeds = geometry::length(at(a, t).velocity) + geometry::length(at(b, t).velocity);
        if (now.gap <= (t == from ? touch_reach : gap_accuracy)) {
            double const least = std::max(rate_rounding * speeds, std::sqrt(2 * bound * lowest_hop * reach));
            if (now.rate < -least) return {t, true, false};
            if (now.rate <= least) {
                Approach const soon = approach_at(a, b, reach, t + blink);
                if (soon.rate < now.rate && soon.gap < now.gap) return {t, true, true};
                t += blink;
                continue;
            }
            t += std::max(glimpse, open_time(0, now.rate, bound));
            continue;
        }
        double const next = t + open_time(std::max(0.0, now.gap), now.rate, bound);
        // The clock cannot tell the rest of the way any more.
        if (next == t) return {t, true, false};
        t = next;
    }
    return {std::min(t, end), false, false};
}

}  // namespace

TimeOfImpact time_of_impact(Leg const& a, Leg const& b, double reach, double from, double until) {
    bool const quadratic = std::holds_alternative<Ballistic>(a.motion) && std::holds_alternative<Ballistic>(b.motion);
    return quadratic ? quadratic_encounter(a, b, reach, from, until) : advanced_encounter(a, b, reach, from, until);
}

double closing_speed(State const& a, State const& b) {
    Vec2 const way = b.position - a.position;
    return -dot(b.velocity - a.velocity, way) / geometry::length(way);
}

void solve_simultaneous_impacts(std::vector<Ball> const& balls, std::vector<Pair> const& pairs,
                                std::vector<State>& states) {
    std::vector<Vec2> normals;
    std::vector<double> impulses(pairs.size(), 0.0), frictions(pairs.size(), 0.0), wanted;
    double fastest = 0;
    for (Pair const& p : pairs) {
        Vec2 const way = states[p.b].position - states[p.a].position;
        normals.push_back(way / geometry::length(way));
        double const closing = -dot(states[p.b].velocity - states[p.a].velocity, normals.back());
        wanted.push_back(std::max(balls[p.a].restitution, balls[p.b].restitution) * closing);
        fastest = std::max(fastest, closing);
    }
    // Gauss-Seidel: `change` pushes a pair on and returns the speed by which it did; until none does any more.
    auto const settle = [&](auto&& change) {
        for (int sweep = 0; sweep < blow_sweeps; ++sweep) {
            double largest = 0;
            for (std::size_t i = 0; i < pairs.size(); ++i) largest = std::max(largest, change(i));
            if (pairs.size() == 1 || largest <= blow_accuracy * fastest) break;
        }
    };
    settle([&](std::size_t i) {
        auto const [a, b] = pairs[i];
        double const speed = dot(states[b].velocity - states[a].velocity, normals[i]);
        double const yield = 1 / balls[a].mass + 1 / balls[b].mass;
        double const impulse = std::max(-impulses[i], (wanted[i] - speed) / yield);
        impulses[i] += impulse;
        push_apart(balls[a], states[a], balls[b], states[b], normals[i], impulse, 0);
        return std::abs(impulse) * yield;
    });
    settle([&](std::size_t i) {
        auto const [a, b] = pairs[i];
        double const friction =
            pair_friction_impulse(balls[a], states[a], balls[b], states[b], normals[i], impulses[i], frictions[i]);
        double const more = friction - frictions[i];
        frictions[i] = friction;
        push_apart(balls[a], states[a], balls[b], states[b], normals[i], 0, more);
        return std::abs(more) * (1 / balls[a].mass + 1 / balls[b].mass);
    });
}

}  // namespace physics
