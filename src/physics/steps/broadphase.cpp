#include "physics/steps/broadphase.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "physics/motion/leg_bounds.h"
#include "physics/steps/contact_island.h"
#include "physics/steps/lone_balls.h"

namespace physics {

using geometry::Box;

namespace {

constexpr double ease = 0.1;  // share of the radius by which a reach is wider than the way ahead asks for

// Where a ball may be within the next `step` seconds, with some to spare so that the next steps need no new look.
Box reach_of(BodyState const& body_state, double step) {
    Vec2 const& p = body_state.state.position;
    Vec2 const a = acceleration_in(*body_state.field, p, body_state.state.velocity);
    double const way = step * (geometry::length(body_state.state.velocity) + step * geometry::length(a));
    double const margin = body_state.ball->radius * (1 + ease) + 2 * way;
    return {p - Vec2::Constant(margin), p + Vec2::Constant(margin)};
}

bool covers(Box const& reach, double radius, Vec2 const& p, Vec2 const& way) {
    double const x = radius + std::abs(way.x()), y = radius + std::abs(way.y());
    return p.x() - x >= reach.low.x() && p.x() + x <= reach.high.x() && p.y() - y >= reach.low.y() &&
           p.y() + y <= reach.high.y();
}

bool knows_all(StepContext const& context) { return context.fat_boxes.size() == context.body_states.size(); }

bool all_covered(StepContext const& context, double time) {
    return std::all_of(context.body_states.begin(), context.body_states.end(), [&](BodyState const& body_state) {
        State const& state = body_state.state;
        Vec2 way = time * state.velocity;
        if (body_state.field->pulled)
            way = way.cwiseAbs() +
                  time * time * acceleration_in(*body_state.field, state.position, state.velocity).cwiseAbs();
        return context.asleep[body_state.index] ||
               covers(context.fat_boxes[body_state.index], body_state.ball->radius, state.position, way);
    });
}

bool before(BallPair const& a, BallPair const& b) {
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
std::vector<PairSpan> spans_of(StepContext const& context, double height) {
    std::vector<PairSpan> spans(context.fat_boxes.size());
    for (std::size_t i = 0; i < spans.size(); ++i) {
        Box const& box = context.fat_boxes[i];
        double const radius = context.body_states[i].ball->radius;
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
std::vector<BallPair> in_order(std::vector<BallPair> const& pairs, std::size_t balls) {
    std::vector<int> end(balls, 0);
    for (BallPair const& pair : pairs) ++end[pair.first];
    for (std::size_t i = 1; i < balls; ++i) end[i] += end[i - 1];
    std::vector<BallPair> ordered(pairs.size());
    for (std::size_t k = pairs.size(); k-- > 0;) ordered[--end[pairs[k].first]] = pairs[k];
    for (std::size_t i = 0; i < balls; ++i) {
        auto const last = i + 1 < balls ? ordered.begin() + end[i + 1] : ordered.end();
        std::sort(ordered.begin() + end[i], last, before);
    }
    return ordered;
}

std::vector<BallPair> near_pairs(StepContext const& context) {
    double height = 0;
    for (Box const& box : context.fat_boxes) height = std::max(height, box.high.y() - box.low.y());
    std::vector<PairSpan> const spans = spans_of(context, height);
    std::vector<BallPair> pairs;
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
    return in_order(pairs, context.fat_boxes.size());
}

void look_for_neighbours(StepContext& context, double time) {
    context.fat_boxes.resize(context.body_states.size());
    for (BodyState const& body_state : context.body_states)
        context.fat_boxes[body_state.index] = reach_of(body_state, time);
    std::vector<BallPair> pairs = near_pairs(context);
    auto old = context.ball_pairs.begin();
    for (BallPair& pair : pairs) {
        while (old != context.ball_pairs.end() && before(*old, pair)) ++old;
        if (old != context.ball_pairs.end() && old->first == pair.first && old->second == pair.second) pair = *old;
    }
    context.ball_pairs = std::move(pairs);
    context.regroup = context.relist = true;
}

constexpr double shortest_look = 1.0 / 16, longest_look = 2;  // s ahead

// m, how far a ball on its plan can get in `time` from a state. An impact turns speed and spin into each other, but
// adds to neither, and what a spring can add is what it holds.
double farthest(BodyState const& body_state, State const& state, double time) {
    Field const& field = *body_state.field;
    double const speed = geometry::length(state.velocity) + body_state.ball->radius * std::abs(state.spin);
    if (!field.pulled) return time * (speed + time * geometry::length(field.gravity));
    Vec2 const stretch = field.target + field.gravity / field.spring.stiffness - state.position;
    return time * (speed + std::sqrt(field.spring.stiffness) * geometry::length(stretch));
}

// Where a ball on its plan can be from `now` until `then`: on its leg, and anywhere that it can get to after that.
Box reach_of_plan(BodyState const& body_state, Leg const& leg, double now, double then) {
    double const end = std::clamp(leg.until, now, then);
    LegPart const part(leg, now - leg.since, end - leg.since);
    Range const x = part.along(Vec2::Zero(), Vec2::UnitX()), y = part.along(Vec2::Zero(), Vec2::UnitY());
    Box box{{x.low, y.low}, {x.high, y.high}};
    if (end < then) {
        State const state = at(leg, end);
        Vec2 const margin = Vec2::Constant(farthest(body_state, state, then - end));
        box = geometry::united(box, {state.position - margin, state.position + margin});
    }
    return geometry::grown(box, body_state.ball->radius);
}

bool any_overlap(std::vector<Box>& boxes) {
    std::sort(boxes.begin(), boxes.end(), [](Box const& a, Box const& b) { return a.low.x() < b.low.x(); });
    for (auto a = boxes.begin(); a != boxes.end(); ++a)
        for (auto b = a + 1; b != boxes.end() && b->low.x() <= a->high.x(); ++b)
            if (geometry::overlap(*a, *b)) return true;
    return false;
}

}  // namespace

double clear_span(StepContext const& context, double now) {
    if (!context.ball_pairs.empty()) return 0;
    double clear = 0;
    std::vector<Box> boxes;
    for (double span = shortest_look; span <= longest_look; span *= 2) {
        boxes.clear();
        for (BodyState const& body_state : context.body_states)
            boxes.push_back(reach_of_plan(body_state, context.world.legs[body_state.index], now, now + span));
        if (any_overlap(boxes)) break;
        clear = span;
    }
    return clear;
}

void mark_alone(StepContext& context) {
    context.alone.assign(context.body_states.size(), 1);
    for (BallPair const& pair : context.ball_pairs) context.alone[pair.first] = context.alone[pair.second] = 0;
}

void find_neighbours(StepContext& context, double step) {
    if (context.body_states.size() < 2 || (!context.looked_anew && knows_all(context) && all_covered(context, step)))
        return;
    look_for_neighbours(context, step);
    context.looked_anew = false;
    mark_alone(context);
}

void find_more_neighbours(StepContext& context, std::vector<int> const& balls) {
    bool const covered = std::all_of(balls.begin(), balls.end(), [&](int i) {
        SolverBody const& body = context.island.bodies[i + 1];
        return covers(context.fat_boxes[i], body.radius, body.position, Vec2::Zero());
    });
    if (covered) return;
    look_for_neighbours(context, context.step);
    context.looked_anew = true;
    std::erase_if(context.ball_pairs,
                  [&](BallPair const& pair) { return context.alone[pair.first] || context.alone[pair.second]; });
}

std::vector<CachedContact> all_touches(ContactIsland const& island) {
    std::vector<CachedContact> all;
    std::merge(island.cached_contacts.begin(), island.cached_contacts.end(), island.left.begin(), island.left.end(),
               std::back_inserter(all), [](CachedContact const& a, CachedContact const& b) { return a.ball < b.ball; });
    return all;
}

bool group(StepContext& context) {
    if (!context.regroup) return false;
    std::size_t const count = context.body_states.size();
    context.leaning.assign(count, 0);
    std::vector<int> const live_before = std::exchange(context.live, {});
    context.live.reserve(live_before.size());
    context.island.pairs.clear();
    for (std::size_t k = 0; k < context.ball_pairs.size(); ++k) {
        BallPair const& pair = context.ball_pairs[k];
        bool const live = !context.asleep[pair.first] || !context.asleep[pair.second];
        if (live) context.live.push_back(static_cast<int>(k));
        if (!pair.leaning) continue;
        context.leaning[pair.first] = context.leaning[pair.second] = 1;
        if (live) context.island.pairs.push_back(static_cast<int>(k));
    }
    if (context.relist || context.live != live_before) context.pairs_of.clear();
    context.regroup = context.relist = false;
    context.awake.clear();
    context.free.clear();
    context.island.balls.clear();
    context.departures.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (context.asleep[i]) depart(context, static_cast<int>(i), 0, 0);
        if (context.asleep[i] || context.alone[i]) continue;
        context.awake.push_back(static_cast<int>(i));
        (context.leaning[i] ? context.island.balls : context.free).push_back(static_cast<int>(i));
    }
    std::vector<CachedContact> const cached_contacts = all_touches(context.island);
    context.island.cached_contacts.clear();
    context.island.left.clear();
    for (CachedContact const& touch : cached_contacts)
        if (context.leaning[touch.ball])
            (context.asleep[touch.ball] ? context.island.left : context.island.cached_contacts).push_back(touch);
    gather_pile(context);
    return true;
}

void release_parted(StepContext& context, double now) {
    for (BodyState& body_state : context.body_states) {
        int const i = body_state.index;
        if (context.leaning[i] || !is_stepped(context.world, i)) continue;
        end_chord(context, i, now);
        release(context.scene, context.world, context.history, i, now);
        body_state.state = at(context.world.legs[i], now);
        body_state.contact = context.world.legs[i].contact;
    }
}

void remember_departures(StepContext& context, double until) {
    for (int const i : context.island.balls) {
        context.departures[i].state = context.body_states[i].state;
        context.departures[i].time = 0;
    }
    for (int const i : context.free) depart(context, i, 0, until);
}

}  // namespace physics
