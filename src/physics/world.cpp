#include "physics/world.h"

#include <algorithm>

#include "geometry/elementary.h"

namespace physics {

Vec2 gravity_of(Scene const& scene, Forces const& forces) {
    auto const [sine, cosine] = geometry::sine_cosine(forces.tilt);
    return geometry::turned(Vec2(0, -scene.gravity), cosine, sine);
}

void forget_before(History& history, double time) {
    for (std::deque<Leg>& legs : history.legs)
        while (legs.size() > 1 && legs[1].since <= time) legs.pop_front();
    while (!history.events.empty() && history.events.front().time < time) history.events.pop_front();
    history.from = std::max(history.from, time);
}

Leg const& leg_at(History const& history, int ball, double t) {
    std::deque<Leg> const& legs = history.legs[ball];
    if (legs.back().since <= t) return legs.back();
    auto const after =
        std::upper_bound(legs.begin(), legs.end(), t, [](double time, Leg const& leg) { return time < leg.since; });
    return after == legs.begin() ? legs.front() : *(after - 1);
}

State state_at(History const& history, int ball, double t) { return at(leg_at(history, ball, t), t); }

}  // namespace physics
