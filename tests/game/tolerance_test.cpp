#include "game/tolerance.h"

#include <cmath>

#include <doctest/doctest.h>

#include "physics/overlap.h"

namespace {

constexpr double g = 9.81;  // m/s^2

std::shared_ptr<level::Level const> level_of(std::vector<physics::Ball> balls) {
    auto level = std::make_shared<level::Level>();
    level->file = "level.svg";
    level->size = {16, 9};
    level->scene.gravity = g;
    level->scene.balls = std::move(balls);
    return level;
}

physics::Ball ball_at(double x, double y) {
    physics::Ball ball;
    ball.start.position = {x, y};
    return ball;
}

}  // namespace

TEST_CASE("the error of a ball in free fall under steps is what the chord leaves of the parabola, g h^2 / 8") {
    double const rate = 240, sag = g / (8 * rate * rate);  // m
    for (double const every : {1.0, 1.0 / 60, 1e-3}) {
        game::Session session = game::session_of(level_of({ball_at(0, 0)}), physics::Steps{rate, 4});
        game::watch_tolerance(session, 1.01 * sag);
        for (double t = 0; t < 1; t += every) {
            game::advance(session, t + every);
            game::forget_before(session, t + every);
        }
        REQUIRE(session.watch);
        CHECK(session.watch->reached == doctest::Approx(sag).epsilon(1e-6));
        CHECK_FALSE(game::missed_tolerance(session));
        session.watch->tolerance = 0.99 * sag;
        CHECK(game::missed_tolerance(session));
    }
}

TEST_CASE("one ball under exact is promised and not watched, several and steps are not") {
    auto const one = level_of({ball_at(0, 0)}), two = level_of({ball_at(0, 0), ball_at(3, 0)});
    CHECK(game::is_promised(physics::Exact{}, one->scene));
    CHECK(game::doubt_about(physics::Exact{}, one->scene).empty());
    game::Session session = game::session_of(one, physics::Exact{});
    game::watch_tolerance(session, 1e-9);
    CHECK_FALSE(session.watch);
    CHECK_FALSE(game::is_promised(physics::Steps{}, one->scene));
    CHECK_FALSE(game::is_promised(physics::Exact{}, two->scene));
    session = game::session_of(two, physics::Exact{});
    game::watch_tolerance(session, 1e-9);
    REQUIRE(session.watch);
    game::advance(session, 1);
    CHECK(session.watch->reached == 0);
}

TEST_CASE("an input that steps take late is an error against the exact path") {
    // Gravity is turned by 0.3 rad at 0.105 s, under ten steps a second at 0.2 s.
    auto const level = level_of({ball_at(0, 0)});
    game::Session session = game::session_of(level, physics::Steps{10, 4}, {{0.105, game::Tilt{0.3}}});
    game::watch_tolerance(session, 1e-3);
    game::advance(session, 1);
    // From then on the velocities differ by 0.095 s of 2 g sin 0.15.
    double const speed = 0.095 * 2 * g * std::sin(0.15);
    CHECK(session.watch->reached >= 0.8 * speed);
    CHECK(session.watch->reached <= speed + g / 800);
}

TEST_CASE("the deepest overlap is that of any two balls, or of a ball with terrain") {
    physics::Scene scene;
    for (int i = 0; i < 20; ++i) scene.balls.push_back(ball_at(2 * i, 0));
    std::vector<geometry::Vec2> centres;
    for (physics::Ball const& ball : scene.balls) centres.push_back(ball.start.position);
    scene.terrain = physics::terrain_of({{geometry::Segment{{-1, -0.5}, {50, -0.5}}, {}, 0}});
    CHECK(physics::deepest_overlap(scene, centres) == 0);
    centres[7].y() = -0.02;
    CHECK(physics::deepest_overlap(scene, centres) == doctest::Approx(0.02));
    centres[3] = {8.6, 0.8};  // just 1 m from the ball at (8, 0)
    CHECK(physics::deepest_overlap(scene, centres) == doctest::Approx(0.02));
    centres[3] = {8.3, 0.4};
    CHECK(physics::deepest_overlap(scene, centres) == doctest::Approx(0.5));
}
