#include <doctest/doctest.h>

#include "game/past.h"
#include "scenes/levels.h"

namespace {

game::Session played(physics::Method const& method, double until, game::PastLimits const& limits) {
    game::Session session = game::session_of(scenes::read_level(ASSETS "/lab/valley.svg"), method);
    for (int second = 1; second <= until; ++second) {
        game::advance(session, second);
        game::keep_past(session, second, limits);
    }
    return session;
}

}  // namespace

TEST_CASE("the past is kept for its time, and answers as it did") {
    game::PastLimits limits;
    limits.longest = 20;
    game::Session const kept = played(physics::Exact{}, 60, limits);
    CHECK(kept.history.from == 40);
    game::Session const whole = played(physics::Exact{}, 60, {});
    CHECK(whole.history.from == 0);
    for (double const t : {40.0, 47.3, 60.0}) CHECK(game::state_hash(kept, t) == game::state_hash(whole, t));
}

TEST_CASE("the past takes no more memory than it may, but never less than the shortest") {
    game::PastLimits limits;
    limits.bytes = 10 * 240 * sizeof(physics::Leg);
    game::Session const some = played(physics::Euler{}, 60, limits);
    CHECK(game::bytes_of(some.history, some.method) <= limits.bytes);
    CHECK(some.history.from < 60 - limits.shortest);
    limits.bytes = 0;
    game::Session const least = played(physics::Euler{}, 60, limits);
    CHECK(least.history.from == 60 - limits.shortest);
}
