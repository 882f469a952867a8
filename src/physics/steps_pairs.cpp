#include "physics/steps_pairs.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "physics/steps_pile.h"
#include "physics/steps_plan.h"

namespace physics {

using geometry::Box;

namespace {

constexpr double ease = 0.1;  // share of the radius by which a reach is wider than the way ahead asks for

// Where a ball may be within the next `step` seconds, with some to spare so that the next steps need no new look.
Box reach_of(Traveller const& traveller, double step) {
    Vec2 const& p = traveller.state.position;
    Vec2 const a = acceleration_in(*traveller.field, p, traveller.state.velocity);
    double const way = step * (geometry::length(traveller.state.velocity) + step * geometry::length(a));
    double const margin = traveller.ball->radius * (1 + ease) + 2 * way;
    return {p - Vec2::Constant(margin), p + Vec2::Constant(margin)};
}

bool covers(Box const& reach, double radius, Vec2 const& p, Vec2 const& way) {
    double const x = radius + std::abs(way.x()), y = radius + std::abs(way.y());
    return p.x() - x >= reach.low.x() && p.x() + x <= reach.high.x() && p.y() - y >= reach.low.y() &&
           p.y() + y <= reach.high.y();
}

bool knows_all(Stage const& stage) { return stage.reaches.size() == stage.travellers.size(); }

bool all_covered(Stage const& stage, double time) {
    return std::all_of(stage.travellers.begin(), stage.travellers.end(), [&](Traveller const& traveller) {
        State const& state = traveller.state;
        Vec2 way = time * state.velocity;
        if (traveller.field->pulled)
            way = way.cwiseAbs() +
                  time * time * acceleration_in(*traveller.field, state.position, state.velocity).cwiseAbs();
        return stage.asleep[traveller.index] ||
               covers(stage.reaches[traveller.index], traveller.ball->radius, state.position, way);
    });
}

bool before(Neighbours const& a, Neighbours const& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
}

// One ball's reach, in the band of the plane in which it begins.
struct PairSpan {
    double band = 0;
    double left = 0, right = 0;  // m
    Vec2 centre = Vec2::Zero();  // m
    double rim = 0;              // m, how far from there its rim can come
    int ball = 0;
};

// Band by band, from left to right. A band is as high as the highest reach, so that one reaches into the next at most.
std::vector<PairSpan> spans_of(Stage const& stage, double height) {
    std::vector<PairSpan> spans(stage.reaches.size());
    for (std::size_t i = 0; i < spans.size(); ++i) {
        Box const& box = stage.reaches[i];
        double const radius = stage.travellers[i].ball->radius;
        double const slack = 0.5 * (box.high.x() - box.low.x()) - radius;
        spans[i] = {std::floor(box.low.y() / height), box.low.x(),        box.high.x(), 0.5 * (box.low + box.high),
                    radius + std::sqrt(2.0) * slack,  static_cast<int>(i)};
    }
    std::sort(spans.begin(), spans.end(), [](PairSpan const& a, PairSpan const& b) {
        if (a.band != b.band) return a.band < b.band;
        return a.left != b.left ? a.left < b.left : a.ball < b.ball;
    });
    return spans;
}

bool may_meet(PairSpan const& a, PairSpan const& b) {
    Vec2 const d = b.centre - a.centre;
    return geometry::dot(d, d) <= (a.rim + b.rim) * (a.rim + b.rim);
}

// In order of the first ball, then of the second.
std::vector<Neighbours> in_order(std::vector<Neighbours> const& pairs, std::size_t balls) {
    std::vector<int> end(balls, 0);
    for (Neighbours const& pair : pairs) ++end[pair.first];
    for (std::size_t i = 1; i < balls; ++i) end[i] += end[i - 1];
    std::vector<Neighbours> ordered(pairs.size());
    for (std::size_t k = pairs.size(); k-- > 0;) ordered[--end[pairs[k].first]] = pairs[k];
    for (std::size_t i = 0; i < balls; ++i) {
        auto const last = i + 1 < balls ? ordered.begin() + end[i + 1] : ordered.end();
        std::sort(ordered.begin() + end[i], last, before);
    }
    return ordered;
}

std::vector<Neighbours> near_pairs(Stage const& stage) {
    double height = 0;
    for (Box const& box : stage.reaches) height = std::max(height, box.high.y() - box.low.y());
    std::vector<PairSpan> const spans = spans_of(stage, height);
    std::vector<Neighbours> pairs;
    auto const add = [&](PairSpan const& a, PairSpan const& b) {
        if (may_meet(a, b)) pairs.push_back({std::min(a.ball, b.ball), std::max(a.ball, b.ball), false, {}, {}});
    };
    auto above = spans.begin();
    for (auto a = spans.begin(); a != spans.end(); ++a) {
        for (auto b = a + 1; b != spans.end() && b->band == a->band && b->left <= a->right; ++b) add(*a, *b);
        while (above != spans.end() &&
               (above->band <= a->band || (above->band == a->band + 1 && above->left + height < a->left)))
            ++above;
        for (auto b = above; b != spans.end() && b->band == a->band + 1 && b->left <= a->right; ++b) add(*a, *b);
    }
    return in_order(pairs, stage.reaches.size());
}

void look_for_neighbours(Stage& stage, double time) {
    stage.reaches.resize(stage.travellers.size());
    for (Traveller const& traveller : stage.travellers) stage.reaches[traveller.index] = reach_of(traveller, time);
    std::vector<Neighbours> pairs = near_pairs(stage);
    auto old = stage.neighbours.begin();
    for (Neighbours& pair : pairs) {
        while (old != stage.neighbours.end() && before(*old, pair)) ++old;
        if (old != stage.neighbours.end() && old->first == pair.first && old->second == pair.second) pair = *old;
    }
    stage.neighbours = std::move(pairs);
    stage.regroup = stage.relist = true;
}

// m, how far a ball on its plan can get in `time`. An impact turns speed and spin into each other, but adds to neither.
double farthest(Traveller const& traveller, double time) {
    State const& state = traveller.state;
    double const speed = geometry::length(state.velocity) + traveller.ball->radius * std::abs(state.spin);
    return time * (speed + time * geometry::length(traveller.field->gravity));
}

constexpr double clear_ahead = 0.25;  // s

}  // namespace

double clear_span(Stage& stage) {
    if (!stage.neighbours.empty() || stage.pulled >= 0) return 0;
    std::vector<Box> const near = stage.reaches;
    for (Traveller const& traveller : stage.travellers) {
        Vec2 const margin = Vec2::Constant(traveller.ball->radius + farthest(traveller, clear_ahead));
        stage.reaches[traveller.index] = {traveller.state.position - margin, traveller.state.position + margin};
    }
    bool const is_clear = near_pairs(stage).empty();
    stage.reaches = near;
    return is_clear ? clear_ahead : 0;
}

void mark_alone(Stage& stage) {
    stage.alone.assign(stage.travellers.size(), 1);
    for (Neighbours const& pair : stage.neighbours) stage.alone[pair.first] = stage.alone[pair.second] = 0;
}

void find_neighbours(Stage& stage, double step) {
    if (stage.travellers.size() < 2 || (!stage.looked_anew && knows_all(stage) && all_covered(stage, step))) return;
    look_for_neighbours(stage, step);
    stage.looked_anew = false;
    mark_alone(stage);
}

void find_more_neighbours(Stage& stage, std::vector<int> const& balls) {
    bool const covered = std::all_of(balls.begin(), balls.end(), [&](int i) {
        Body const& body = stage.pile.bodies[i + 1];
        return covers(stage.reaches[i], body.radius, body.position, Vec2::Zero());
    });
    if (covered) return;
    look_for_neighbours(stage, stage.step);
    stage.looked_anew = true;
    std::erase_if(stage.neighbours,
                  [&](Neighbours const& pair) { return stage.alone[pair.first] || stage.alone[pair.second]; });
}

std::vector<Touch> all_touches(Pile const& pile) {
    std::vector<Touch> all;
    std::merge(pile.touches.begin(), pile.touches.end(), pile.left.begin(), pile.left.end(), std::back_inserter(all),
               [](Touch const& a, Touch const& b) { return a.ball < b.ball; });
    return all;
}

bool group(Stage& stage) {
    if (!stage.regroup) return false;
    stage.regroup = stage.relist = false;
    std::size_t const count = stage.travellers.size();
    stage.leaning.assign(count, 0);
    stage.live.clear();
    stage.pile.pairs.clear();
    for (std::size_t k = 0; k < stage.neighbours.size(); ++k) {
        Neighbours const& pair = stage.neighbours[k];
        bool const live = !stage.asleep[pair.first] || !stage.asleep[pair.second];
        if (live) stage.live.push_back(static_cast<int>(k));
        if (!pair.leaning) continue;
        stage.leaning[pair.first] = stage.leaning[pair.second] = 1;
        if (live) stage.pile.pairs.push_back(static_cast<int>(k));
    }
    stage.awake.clear();
    stage.free.clear();
    stage.pile.balls.clear();
    stage.departures.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (stage.asleep[i]) depart(stage, static_cast<int>(i), 0);
        if (stage.asleep[i] || stage.alone[i]) continue;
        stage.awake.push_back(static_cast<int>(i));
        (stage.leaning[i] ? stage.pile.balls : stage.free).push_back(static_cast<int>(i));
    }
    std::vector<Touch> const touches = all_touches(stage.pile);
    stage.pile.touches.clear();
    stage.pile.left.clear();
    for (Touch const& touch : touches)
        if (stage.leaning[touch.ball])
            (stage.asleep[touch.ball] ? stage.pile.left : stage.pile.touches).push_back(touch);
    gather_pile(stage);
    return true;
}

void release_parted(Stage& stage, double now) {
    for (Traveller& traveller : stage.travellers) {
        int const i = traveller.index;
        if (stage.leaning[i] || !is_stepped(stage.world, i)) continue;
        end_chord(stage, i, now);
        release(stage.scene, stage.world, stage.history, i, now);
        traveller.state = at(stage.world.legs[i], now);
        traveller.contact = stage.world.legs[i].contact;
    }
}

void remember_departures(Stage& stage) {
    for (int const i : stage.pile.balls) {
        stage.departures[i].state = stage.travellers[i].state;
        stage.departures[i].time = 0;
    }
    for (int const i : stage.free) depart(stage, i, 0);
}

}  // namespace physics
