#include "game/past.h"

#include <algorithm>

namespace game {

namespace {

// Of the past, so much goes at a time when there is too much of it: one part in eight, so that it goes rarely.
constexpr double part_dropped = 1.0 / 8;

}  // namespace

std::size_t bytes_of(physics::History const& history, physics::Method const& method) {
    bool const writes_series = std::holds_alternative<physics::Exact>(method);
    std::size_t const leg = sizeof(physics::Leg) + (writes_series ? sizeof(physics::CircleSeries) : 0);
    std::size_t bytes = history.events.size() * sizeof(physics::Event);
    for (auto const& legs : history.legs) bytes += (legs.size() - 1) * leg;
    return bytes;
}

void keep_past(Session& session, double now, PastLimits const& limits) {
    forget_before(session, now - limits.longest);
    double const latest = now - limits.shortest;
    while (bytes_of(session.history, session.method) > limits.bytes && session.history.from < latest) {
        double const from = session.history.from;
        forget_before(session, std::min(from + std::max((now - from) * part_dropped, 1.0), latest));
    }
}

}  // namespace game
