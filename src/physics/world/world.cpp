#include "physics/world/world.h"

#include <algorithm>

#include "geometry/elementary.h"

namespace physics {

Vec2 gravity_of(Scene const& scene, Forces const& forces) {
    if (forces.tilt == 0) return {0, -scene.gravity};
    auto const [sine, cosine] = geometry::sine_cosine(forces.tilt);
    return geometry::turned(Vec2(0, -scene.gravity), cosine, sine);
}

void forget_before(History& history, double time) {
    for (Trail<Leg>& legs : history.legs) {
        auto first = legs.begin();
        while (first + 1 != legs.end() && (first + 1)->since <= time) ++first;
        legs.forget_before(first);
    }
    Trail<Event>& events = history.events;
    events.forget_before(std::find_if(events.begin(), events.end(), [=](Event const& e) { return e.time >= time; }));
    history.from = std::max(history.from, time);
}

Leg const& leg_at(Trail<Leg> const& legs, double t) {
    auto const after =
        std::upper_bound(legs.begin(), legs.end(), t, [](double time, Leg const& leg) { return time < leg.since; });
    return after == legs.begin() ? legs.front() : *(after - 1);
}

}  // namespace physics
