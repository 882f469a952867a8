#include "physics/advice.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {

using physics::Exact;
using physics::Experience;
using physics::Scene;
using physics::Steps;
using physics::Vec2;

// Round numbers, so that what follows from them can be worked out by hand.
Experience made_up() {
    Experience seen;
    seen.exact_error = 1e-12;
    seen.exact_ball = 5000;
    seen.exact_pair = 1000;
    seen.exact_joint = 100;
    seen.steps_frame = 100;
    seen.steps_step = 100;
    seen.kink_error = 0.5;
    seen.sag_error = 0.125;
    seen.piles = {{60, 10, 0.001, 1000}, {60, 1000, 0.1, 2000}, {120, 10, 0.0001, 3000}, {120, 1000, 0.01, 6000}};
    return seen;
}

// Discs at 1 m/s without gravity and spring, far apart.
Scene balls(int count) {
    Scene scene;
    scene.gravity = 0;
    scene.drag.frequency = 0;
    for (int i = 0; i < count; ++i) {
        physics::Ball ball;
        ball.start = {Vec2(3.0 * i, 0), Vec2(1, 0), 0, 0};
        scene.balls.push_back(ball);
    }
    return scene;
}

double rate_of(physics::Choice const& choice) {
    auto const* steps = std::get_if<Steps>(&choice.method);
    return steps ? steps->rate : 0;
}

}  // namespace

TEST_CASE("the cheaper of two methods that keep the tolerance is advised, and half of it is what counts") {
    // 5000 against 100 (60 + rate) ns: exact is cheaper but where a step costs next to nothing.
    CHECK(std::holds_alternative<Exact>(advice_for(balls(1), 1, made_up()).method));
    Experience cheap = made_up();
    cheap.exact_pair = 1e9;
    // Two balls at 1 m/s: 0.5 m/s / rate is at most half the tolerance at rates of 1/tolerance and above.
    CHECK(rate_of(advice_for(balls(2), 1.0 / 60, cheap)) == 60);
    CHECK(rate_of(advice_for(balls(2), 0.999 / 60, cheap)) == 120);
    CHECK(rate_of(advice_for(balls(2), 1.0 / 960, cheap)) == 960);
    CHECK(std::holds_alternative<Exact>(advice_for(balls(2), 1e-6, cheap).method));
}

TEST_CASE("the methods cross where the pairs of the one cost as much as the steps of the other") {
    // 5000 n + 1000 n (n - 1) / 2 against 12000 n ns: exact is cheaper below 15 balls.
    Experience const seen = made_up();
    CHECK(std::holds_alternative<Exact>(advice_for(balls(14), 1, seen).method));
    CHECK(rate_of(advice_for(balls(16), 1, seen)) == 60);
}

TEST_CASE("no tolerance breaks the promise of needs: piles are for steps alone") {
    Scene pile = balls(30);
    pile.gravity = 9.81;
    for (double const tolerance : {1.0, 1e-3, 1e-9})
        CHECK(std::holds_alternative<Steps>(advice_for(pile, tolerance, made_up()).method));
    for (double const tolerance : {1.0, 1e-3, 1e-9})
        CHECK_FALSE(std::holds_alternative<physics::Article>(advice_for(balls(1), tolerance, made_up()).method));
}

TEST_CASE("the overlap of a pile is foretold between measured piles, by gravity and by masses") {
    // From 0.001 at 10 balls to 0.1 at 1000: 0.01 radii at 100, 0.005 m with radius 0.5 m.
    Scene pile = balls(100);
    pile.gravity = 9.81;
    CHECK(forecasts_for(pile, made_up())[0].error == doctest::Approx(0.005).epsilon(1e-12));
    CHECK(forecasts_for(pile, made_up())[0].cost == doctest::Approx(200000).epsilon(1e-12));
    CHECK(rate_of(advice_for(pile, 0.0101, made_up())) == 60);
    CHECK(rate_of(advice_for(pile, 0.0099, made_up())) == 120);
    pile.gravity = 2 * 9.81;
    pile.balls[7].mass = 3;
    CHECK(forecasts_for(pile, made_up())[0].error == doctest::Approx(0.03).epsilon(1e-12));
}

TEST_CASE("what cannot be kept is said, with the nearest there is") {
    Scene pile = balls(100);
    pile.gravity = 9.81;
    physics::Choice const choice = advice_for(pile, 1e-6, made_up());
    CHECK(rate_of(choice) == 120);
    CHECK(choice.why.rfind("nothing is known to keep 1e-06 m; nearest, steps at 120 steps/s", 0) == 0);
    // Alone and without forces: 5000 against 100 * 60 + 100 * 60 ns.
    CHECK(advice_for(balls(1), 1e-6, made_up()).why ==
          "the cheapest known to keep 1e-06 m, exact: 5 us a simulated second, error up to 1e-12 m; "
          "next, steps at 60 steps/s: 12 us a simulated second, error up to 0 m");
}

TEST_CASE("steps as advised keep the tolerance where a ball bounces, between steps too") {
    // Dropped from height H with restitution 1: at time t into an arch of length 2 T, T = sqrt(2 H / g).
    Scene scene = balls(1);
    scene.gravity = 9.81;
    scene.balls[0].start = {Vec2(0, 2.5), Vec2::Zero(), 0, 0};
    scene.terrain = physics::terrain_of({{geometry::Segment{{-9, 0}, {9, 0}}, {0.9, 1, 0}, 0}});
    double const height = 2, fall = std::sqrt(2 * height / scene.gravity);
    Experience dear = physics::experience();
    dear.exact_ball = 1e12;
    for (double const tolerance : {1e-1, 1e-2, 1e-3}) {
        physics::Method const method = advice_for(scene, tolerance, dear).method;
        REQUIRE(std::holds_alternative<Steps>(method));
        physics::History history;
        physics::World world = physics::world_at_start(method, scene, history);
        physics::advance(method, scene, world, 3, history);
        for (int i = 0; i < 3000; ++i) {
            double const t = i / 1000.0, since = std::remainder(t, 2 * fall);
            double const y = 0.5 + height - scene.gravity * since * since / 2;
            REQUIRE(std::abs(physics::state_at(history, 0, t).position.y() - y) <= tolerance);
        }
    }
}

TEST_CASE("what the benchmark has measured is whole") {
    Experience const& seen = physics::experience();
    for (double const number : {seen.exact_error, seen.exact_ball, seen.exact_pair, seen.exact_joint, seen.steps_frame,
                                seen.steps_step, seen.kink_error, seen.sag_error})
        CHECK((std::isfinite(number) && number > 0));
    CHECK(seen.exact_error <= 1e-10);
    // A straight line that cuts a parabola is off by a h^2 / 8 at most.
    CHECK(seen.sag_error >= 0.12);
    REQUIRE(seen.piles.size() >= 2);
}
