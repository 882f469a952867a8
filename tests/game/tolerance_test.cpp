#include "game/tolerance.h"

#include <cmath>

#include <doctest/doctest.h>

#include "physics/world/overlap.h"
#include "scenes/levels.h"

using namespace scenes;

TEST_CASE("the error of a ball in free fall under euler is that of its velocity, a step ahead: g h t / 2") {
    double const rate = 240, lead = g / (2 * rate);  // m, after 1 s
    for (double const every : {1.0, 1.0 / 60, 1.0 / 120}) {
        game::Session session = session_of(level_with({disc_at({0, 0})}), physics::Euler{rate});
        game::watch_tolerance(session, 1.01 * lead);
        for (double t = 0; t < 1 - 1e-9; t += every) {
            game::advance(session, t + every);
            game::forget_before(session, t + every);
        }
        REQUIRE(session.watch);
        // The last call may end a step later.
        CHECK(session.watch->reached == doctest::Approx(lead * session.world.time).epsilon(1e-6));
        CHECK(session.world.time <= 1 + 1.01 / rate);
        session.watch->tolerance = 0.99 * lead;
        CHECK(game::missed_tolerance(session));
    }
}

TEST_CASE("a ball alone is under steps where exact has it, to the bit, whatever the rate") {
    level::Level const level = level_with({disc_at({0, 0})});
    auto const played = [&](physics::Method const& method) {
        game::Session session = session_of(level, method, {{0.105, game::Tilt{0.3}}});
        game::advance(session, 1);
        return session;
    };
    game::Session const steps = played(physics::Steps{10, 4}), exact = played(physics::Exact{});
    for (double const t : {0.05, 0.1, 0.107, 0.25, 0.7777, 1.0})
        CHECK(physics::state_at(steps.history, 0, t).position == physics::state_at(exact.history, 0, t).position);
}

TEST_CASE("one ball under exact and steps is promised and not watched, several and other methods are not") {
    level::Level const one = level_with({disc_at({0, 0})}), two = level_with({disc_at({0, 0}), disc_at({3, 0})});
    for (physics::Method const& method : {physics::Method(physics::Exact{}), physics::Method(physics::Steps{})}) {
        CHECK(game::is_promised(method, one.scene));
        CHECK(game::doubt_about(method, one.scene).empty());
        CHECK_FALSE(game::is_promised(method, two.scene));
        CHECK_FALSE(game::doubt_about(method, two.scene).empty());
        game::Session session = session_of(one, method);
        game::watch_tolerance(session, 1e-9);
        CHECK_FALSE(session.watch);
    }
    CHECK_FALSE(game::is_promised(physics::Euler{}, one.scene));
    CHECK_FALSE(game::doubt_about(physics::Euler{}, one.scene).empty());
    game::Session session = session_of(two, physics::Exact{});
    game::watch_tolerance(session, 1e-9);
    REQUIRE(session.watch);
    game::advance(session, 1);
    CHECK(session.watch->reached == 0);
}

TEST_CASE("an input that steps take late is an error against the exact path") {
    // Without gravity article flies on the spring exactly, from the step on at which the grab acts.
    level::Level level = level_with({disc_at({0, 0})}, 0);
    level.drag_reach = 4;
    auto const error_of = [&](double grab) {
        game::Session session = session_of(level, physics::Article{240}, {{grab, game::Grab{0, {1, 0}}}});
        game::watch_tolerance(session, 1e-3);
        game::advance(session, 1);
        return session.watch->reached;
    };
    CHECK(error_of(0.1 + 1.0 / 480) > 10 * error_of(0.1));
}

TEST_CASE("the deepest overlap is that of any two balls, or of a ball with terrain") {
    physics::Scene scene;
    for (int i = 0; i < 20; ++i) scene.balls.push_back(disc_at({2.0 * i, 0}));
    std::vector<geometry::Vec2> centres;
    for (physics::Ball const& ball : scene.balls) centres.push_back(ball.start.position);
    scene.terrain = physics::terrain_of({line({-1, -0.5}, {50, -0.5})});
    CHECK(physics::deepest_overlap(scene, centres) == 0);
    centres[7].y() = -0.02;
    CHECK(physics::deepest_overlap(scene, centres) == doctest::Approx(0.02));
    centres[3] = {8.6, 0.8};  // just 1 m from the ball at (8, 0)
    CHECK(physics::deepest_overlap(scene, centres) == doctest::Approx(0.02));
    centres[3] = {8.3, 0.4};
    CHECK(physics::deepest_overlap(scene, centres) == doctest::Approx(0.5));
}
