#include "physics/world.h"

#include <algorithm>

#include "geometry/elementary.h"

namespace physics {

Vec2 gravity_of(Scene const& scene, Forces const& forces) {
    auto const [sine, cosine] = geometry::sine_cosine(forces.tilt);
    return geometry::turned(Vec2(0, -scene.gravity), cosine, sine);
}

void forget_before(History& history, double time) {
    for (Trail<Leg>& legs : history.legs) {
        std::size_t over = 0;
        while (over + 1 < legs.size() && legs[over + 1].since <= time) ++over;
        if (over > 0) legs.forget(over);
    }
    std::size_t past = 0;
    while (past < history.events.size() && history.events[past].time < time) ++past;
    if (past > 0) history.events.forget(past);
    history.from = std::max(history.from, time);
}

Leg const& leg_at(Trail<Leg> const& legs, double t) {
    auto const after =
        std::upper_bound(legs.begin(), legs.end(), t, [](double time, Leg const& leg) { return time < leg.since; });
    return after == legs.begin() ? legs.front() : *(after - 1);
}

}  // namespace physics
