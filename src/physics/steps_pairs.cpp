#include "physics/steps_pairs.h"

#include <algorithm>
#include <cmath>

namespace physics {

using geometry::Box;

namespace {

constexpr double ease = 0.1;  // share of the radius by which a box is wider than the way ahead asks for

// Where a ball may be within the next `step` seconds, with some to spare so that the next steps need no new look.
Box reach_of(Traveller const& traveller, double step) {
    Vec2 const& p = traveller.state.position;
    Vec2 const a = acceleration_in(traveller.field, p, traveller.state.velocity);
    double const way = step * (geometry::length(traveller.state.velocity) + step * geometry::length(a));
    double const margin = traveller.ball->radius * (1 + ease) + 2 * way;
    return {p - Vec2::Constant(margin), p + Vec2::Constant(margin)};
}

bool covers(Box const& known, Traveller const& traveller, double step) {
    Vec2 const& p = traveller.state.position;
    double const ahead = traveller.ball->radius + step * geometry::length(traveller.state.velocity);
    return p.x() - ahead >= known.low.x() && p.x() + ahead <= known.high.x() && p.y() - ahead >= known.low.y() &&
           p.y() + ahead <= known.high.y();
}

bool before(Encounter const& a, Encounter const& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
}

void sort_from_left(Stage& stage) {
    if (stage.order.size() != stage.travellers.size()) {
        stage.order.resize(stage.travellers.size());
        for (std::size_t i = 0; i < stage.order.size(); ++i) stage.order[i] = static_cast<int>(i);
    }
    std::sort(stage.order.begin(), stage.order.end(), [&](int a, int b) {
        double const left = stage.known[a].low.x(), right = stage.known[b].low.x();
        return left != right ? left < right : a < b;
    });
}

std::vector<Encounter> overlapping_pairs(Stage const& stage) {
    std::vector<Encounter> pairs;
    for (std::size_t i = 0; i < stage.order.size(); ++i) {
        int const a = stage.order[i];
        for (std::size_t j = i + 1; j < stage.order.size(); ++j) {
            int const b = stage.order[j];
            if (stage.known[b].low.x() > stage.known[a].high.x()) break;
            if (overlap(stage.known[a], stage.known[b])) pairs.push_back({std::min(a, b), std::max(a, b), false, {}});
        }
    }
    std::sort(pairs.begin(), pairs.end(), before);
    return pairs;
}

}  // namespace

void recall_touches(Stage& stage, std::vector<Touch> const& touches) {
    for (Touch const& touch : touches)
        if (touch.other >= 0)
            stage.encounters.push_back({touch.ball, touch.other, true, {touch.normal_impulse, touch.tangent_impulse}});
        else
            stage.ground.push_back(touch);
}

std::vector<Touch> touches_of(Stage const& stage) {
    std::vector<Touch> touches = stage.ground;
    for (Encounter const& e : stage.encounters)
        if (e.leaning) touches.push_back({e.first, e.second, {}, e.impulse.normal, e.impulse.tangent});
    return touches;
}

namespace {

bool all_covered(Stage const& stage, double time) {
    bool covered = stage.known.size() == stage.travellers.size();
    for (std::size_t i = 0; covered && i < stage.travellers.size(); ++i)
        covered = covers(stage.known[i], stage.travellers[i], time);
    return covered;
}

void look_for_pairs(Stage& stage, double time) {
    auto const count = stage.travellers.size();
    stage.known.resize(count);
    for (std::size_t i = 0; i < count; ++i) stage.known[i] = reach_of(stage.travellers[i], time);
    sort_from_left(stage);
    std::vector<Encounter> pairs = overlapping_pairs(stage);
    auto old = stage.encounters.begin();
    for (Encounter& pair : pairs) {
        while (old != stage.encounters.end() && before(*old, pair)) ++old;
        if (old != stage.encounters.end() && old->first == pair.first && old->second == pair.second) pair = *old;
    }
    stage.encounters = std::move(pairs);
}

}  // namespace

void find_encounters(Stage& stage, double step) {
    stage.alone.resize(stage.travellers.size(), 1);
    if (stage.travellers.size() < 2 || (!stage.looked_anew && all_covered(stage, step))) return;
    look_for_pairs(stage, step);
    stage.looked_anew = false;
    std::fill(stage.alone.begin(), stage.alone.end(), char{1});
    for (Encounter const& e : stage.encounters) stage.alone[e.first] = stage.alone[e.second] = 0;
}

void find_more_encounters(Stage& stage, double rest) {
    if (all_covered(stage, rest)) return;
    look_for_pairs(stage, rest);
    stage.looked_anew = true;
    std::erase_if(stage.encounters, [&](Encounter const& e) { return stage.alone[e.first] || stage.alone[e.second]; });
}

void wake_neighbours(Stage& stage) {
    for (bool woken = true; woken;) {
        woken = false;
        for (Encounter const& e : stage.encounters) {
            if (!e.leaning || stage.asleep[e.first] == stage.asleep[e.second]) continue;
            stage.asleep[e.first] = stage.asleep[e.second] = 0;
            woken = true;
        }
    }
}

void remember_departures(Stage& stage) {
    if (stage.encounters.empty()) return;
    stage.departures.resize(stage.travellers.size());
    for (std::size_t i = 0; i < stage.travellers.size(); ++i)
        stage.departures[i] = {stage.travellers[i].state, stage.travellers[i].contact, 0};
}

bool mark_leaning(Stage& stage) {
    std::fill(stage.leaning.begin(), stage.leaning.end(), char{0});
    bool any = false;
    for (Encounter const& e : stage.encounters) {
        if (!e.leaning) continue;
        stage.leaning[e.first] = stage.leaning[e.second] = 1;
        any = any || !stage.asleep[e.first] || !stage.asleep[e.second];
    }
    return any;
}

}  // namespace physics
