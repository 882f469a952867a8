#include <cmath>

#include <doctest/doctest.h>

#include "physics/article.h"
#include "scenes/scenes.h"

using namespace physics;
using namespace scenes;

namespace {

Scene floor_under(std::vector<Ball> balls, double gravity = g) {
    return scene_of({line({-100, 0}, {100, 0})}, std::move(balls), gravity);
}

}  // namespace

TEST_CASE(
    "steps are counted from their origin, and a call of article ends at the first that starts at or after its time") {
    Run run(Article{}, floor_under({disc_at({0, 0.5}, {1, 0})}));
    run.to(0.1001);
    CHECK(run.world.steps_taken == 25);
    CHECK(run.world.time == 25 / 240.0);
}

TEST_CASE("a ball that no other is near is where exact has it, between steps too, and whenever one asks") {
    Ball const ball = disc_at({0, 3}, {1.7, 0}), other = disc_at({50, 3}, {1.7, 0});
    Run exact(Exact{}, floor_under({ball})), once(Steps{}, floor_under({ball, other})), often = once;
    exact.to(1.0001);
    once.to(1.0001);
    for (int i = 1; i <= 137; ++i) often.to(i * (1.0001 / 137));
    CHECK(once.world.time == 1.0001);
    for (Run const* run : {&once, &often}) {
        CHECK(at(run->leg(), 1.0001).position == exact.state().position);
        CHECK(at(run->leg(), 1.0001).spin == exact.state().spin);
    }
    REQUIRE(once.history.events.size() == often.history.events.size());
    for (std::size_t i = 0; i < once.history.events.size(); ++i)
        CHECK(once.history.events[i].time == often.history.events[i].time);
}

TEST_CASE("an input acts at its time on a ball that no other is near, while a pile is stepped elsewhere") {
    Run run(Steps{}, scene_of({line({40, 0}, {60, 0})}, {disc_at({0, 3}), disc_at({50, 0.5}), disc_at({50, 1.5})}));
    run.to(0.1001);
    run.tilt(pi / 2);
    CHECK(run.world.time == 0.1001);
    run.to(0.3);
    State const state = state_at(run.history, 0, 0.3);
    // Down until then, to the right from then on.
    CHECK(state.velocity.y() == doctest::Approx(-9.81 * 0.1001).epsilon(1e-13));
    CHECK(state.velocity.x() == doctest::Approx(9.81 * (0.3 - 0.1001)).epsilon(1e-13));
    for (int ball = 1; ball < 3; ++ball) CHECK(state_at(run.history, ball, 0.3).velocity.x() > 0);
}

TEST_CASE("legs follow on each other without a gap, and the last is the world's own") {
    for (Method const& method : {Method(Article{}), Method(Steps{})}) {
        Run run(method, floor_under({disc_at({0, 1}, {2, 0})}));
        run.to(1);
        auto const& legs = run.history.legs[0];
        for (std::size_t i = 1; i < legs.size(); ++i) {
            REQUIRE(legs[i - 1].until == legs[i].since);
            Vec2 const gap = at(legs[i - 1], legs[i].since).position - at(legs[i], legs[i].since).position;
            REQUIRE(geometry::length(gap) <= 1e-14);
        }
        CHECK(legs.back().since == run.leg().since);
        CHECK(at(legs.back(), run.world.time).position == run.state().position);
    }
}

TEST_CASE("a ball that touches at the start is on its surface from the first leg on, and rests without a landing") {
    Run const run(Steps{}, floor_under({disc_at({0, 0.5 + 5e-10})}));
    CHECK(run.leg().phase != Phase::flight);
    CHECK(run.leg().contact == Contact{0, 1});
    REQUIRE(run.history.events.size() == 1);
    CHECK(run.history.events[0].kind == EventKind::rest);
}

TEST_CASE("a dropped ball without restitution lands once, then rests") {
    Run run(Steps{}, floor_under({disc_at({0, 1.5})}));
    run.to(1);
    REQUIRE(run.history.events.size() == 2);
    CHECK(run.history.events[0].kind == EventKind::land);
    CHECK(run.history.events[0].time == doctest::Approx(std::sqrt(2 / 9.81)).epsilon(1e-12));
    CHECK(run.history.events[1].kind == EventKind::rest);
}

TEST_CASE("a ball left standing moves again when it is pulled") {
    Run run(Steps{}, floor_under({disc_at({0, 0.5})}));
    run.to(2);
    run.pull(0, {1, 0.5});
    run.to(4);
    CHECK(run.state().position.x() == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("a column is pressed together by the weight above over m_eff (2 pi f)^2") {
    struct Case {
        Steps method;
        double frequency;  // Hz: an eighth of 960 substeps a second, a quarter of 240
    };
    std::vector<Ball> column;
    for (int i = 0; i < 10; ++i) column.push_back(disc_at({0, 0.5 + i}));
    for (Case const& c : {Case{{240, 4}, 120}, Case{{60, 4}, 60}}) {
        Run run(c.method, floor_under(column));
        run.to(4);
        double const omega = 2 * pi * c.frequency;
        auto const height = [&](int ball) { return run.state(ball).position.y(); };
        // Balls that fall asleep at 1e-4 m/s may lack 3e-6 m: overlaps are pushed out at some 36 /s.
        for (int i = 1; i < 10; ++i)
            CHECK(1 - (height(i) - height(i - 1)) ==
                  doctest::Approx((10 - i) * 9.81 / (0.5 * omega * omega)).epsilon(0.01).scale(3e-4));
        CHECK(0.5 - height(0) == doctest::Approx(10 * 9.81 / (4 * omega * omega)).epsilon(0.01).scale(3e-4));
    }
}

TEST_CASE("balls asleep in a row wake one after the other when the first is pressed against them") {
    Run run(Steps{}, floor_under({disc_at({0, 0.5}), disc_at({1, 0.5}), disc_at({2, 0.5}), disc_at({3, 0.5})}));
    run.to(2);
    for (Leg const& leg : run.world.legs) REQUIRE(leg.phase == Phase::rest);
    run.pull(0, {0.02, 0.5});
    run.to(4);
    CHECK(run.state(0).position.x() >= 0.019);
    CHECK(run.state(3).position.x() >= 3.019);
}

TEST_CASE("a ball asleep on two others falls when one of them is pulled from under it") {
    Scene scene = scene_of({line({-100, 0}, {100, 0}, material(0.9, 0, 0.5)), line({-0.5, 0}, {-0.5, 5})},
                           {disc_at({0, 0.5}), disc_at({1.2, 0.5}), disc_at({0.6, 0.5 + 0.8})});
    scene.balls[1].friction = scene.balls[2].friction = 0.9;
    Run run(Steps{}, scene);
    run.to(4);
    REQUIRE(run.state(2).position.y() > 1);
    REQUIRE(run.leg(2).phase == Phase::rest);
    run.pull(1, {9, 0.5});
    run.to(6);
    CHECK(run.state(2).position.y() == doctest::Approx(0.5).epsilon(1e-3));
}

TEST_CASE("the article's rule: what is kept is tangent, and the spin is -(v ^ n) / r whatever it was") {
    Scene const scene = floor_under({disc_at({0, 0.5}, {3, -2})}, 0);
    State state = scene.balls[0].start;
    state.spin = 17;
    ArticleStep const step = article_step(scene, {}, 0, state, 1e-3);
    CHECK(step.state.velocity.x() == doctest::Approx(3).epsilon(1e-14));
    CHECK(std::abs(step.state.velocity.y()) <= 1e-14);
    CHECK(step.state.spin == doctest::Approx(-3 / 0.5));
    CHECK(step.state.angle == doctest::Approx(-3 * 1e-3 / 0.5));
}
