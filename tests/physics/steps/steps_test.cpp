#include <cmath>

#include <doctest/doctest.h>

#include "geometry/elementary.h"
#include "physics/article.h"
#include "physics/method.h"

using namespace physics;
using geometry::Arc;
using geometry::pi;
using geometry::Segment;

namespace {

Scene floor_with(Vec2 const& position, Vec2 const& velocity) {
    Scene scene;
    scene.terrain = terrain_of({{Segment{{-100, 0}, {100, 0}}, {}, 0}});
    Ball ball;
    ball.start.position = position;
    ball.start.velocity = velocity;
    scene.balls = {ball};
    return scene;
}

std::vector<Method> const methods = {Article{}, Steps{}};

}  // namespace

TEST_CASE(
    "steps are counted from their origin, and a call of article ends at the first that starts at or after its time") {
    Scene const scene = floor_with({0, 0.5}, {1, 0});
    History history;
    World world = world_at_start(Article{}, scene, history);
    advance(Article{}, scene, world, 0.1001, history);
    CHECK(world.steps_taken == 25);
    CHECK(world.time == 25 / 240.0);
}

TEST_CASE("a ball that no other is near is where exact has it, between steps too, and whenever one asks") {
    Scene scene = floor_with({0, 3}, {1.7, 0});
    History exact_history;
    World exact = world_at_start(Exact{}, scene, exact_history);
    advance(Exact{}, scene, exact, 1.0001, exact_history);
    scene.balls.push_back(scene.balls[0]);
    scene.balls[1].start.position.x() = 50;
    History once_history, often_history;
    World once = world_at_start(Steps{}, scene, once_history), often = world_at_start(Steps{}, scene, often_history);
    advance(Steps{}, scene, once, 1.0001, once_history);
    for (int i = 1; i <= 137; ++i) advance(Steps{}, scene, often, i * (1.0001 / 137), often_history);
    State const right = at(exact.legs[0], exact.time);
    CHECK(once.time == 1.0001);
    for (World const* world : {&once, &often}) {
        CHECK(at(world->legs[0], 1.0001).position == right.position);
        CHECK(at(world->legs[0], 1.0001).spin == right.spin);
    }
    REQUIRE(once_history.events.size() == often_history.events.size());
    for (std::size_t i = 0; i < once_history.events.size(); ++i)
        CHECK(once_history.events[i].time == often_history.events[i].time);
}

TEST_CASE("an input acts at its time on a ball that no other is near, while a pile is stepped elsewhere") {
    Scene scene = floor_with({0, 3}, {0, 0});
    scene.terrain = terrain_of({{Segment{{40, 0}, {60, 0}}, {}, 0}});
    for (double const height : {0.5, 1.5}) {
        scene.balls.push_back(scene.balls[0]);
        scene.balls.back().start.position = {50, height};
    }
    History history;
    World world = world_at_start(Steps{}, scene, history);
    advance(Steps{}, scene, world, 0.1001, history);
    Forces forces;
    forces.tilt = pi / 2;
    apply(Steps{}, scene, world, forces, history);
    CHECK(world.time == 0.1001);
    advance(Steps{}, scene, world, 0.3, history);
    State const state = state_at(history, 0, 0.3);
    // Down until then, to the right from then on.
    CHECK(state.velocity.y() == doctest::Approx(-9.81 * 0.1001).epsilon(1e-13));
    CHECK(state.velocity.x() == doctest::Approx(9.81 * (0.3 - 0.1001)).epsilon(1e-13));
    for (int ball = 1; ball < 3; ++ball) CHECK(state_at(history, ball, 0.3).velocity.x() > 0);
}

TEST_CASE("how often one asks does not change the motion") {
    Scene const scene = floor_with({0, 3}, {1.7, 0});
    for (Method const& method : methods) {
        History once_history, often_history;
        World once = world_at_start(method, scene, once_history), often = world_at_start(method, scene, often_history);
        advance(method, scene, once, 2, once_history);
        for (int i = 1; i <= 480; ++i) advance(method, scene, often, i / 240.0, often_history);
        CHECK(at(once.legs[0], 2).position == at(often.legs[0], 2).position);
        CHECK(at(once.legs[0], 2).spin == at(often.legs[0], 2).spin);
        CHECK(once_history.events.size() == often_history.events.size());
    }
}

TEST_CASE("legs follow on each other without a gap, and the last is the world's own") {
    Scene const scene = floor_with({0, 1}, {2, 0});
    for (Method const& method : methods) {
        History history;
        World world = world_at_start(method, scene, history);
        advance(method, scene, world, 1, history);
        auto const& legs = history.legs[0];
        for (std::size_t i = 1; i < legs.size(); ++i) {
            REQUIRE(legs[i - 1].until == legs[i].since);
            Vec2 const gap = at(legs[i - 1], legs[i].since).position - at(legs[i], legs[i].since).position;
            REQUIRE(geometry::length(gap) <= 1e-14);
        }
        CHECK(legs.back().since == world.legs[0].since);
        CHECK(at(legs.back(), world.time).position == at(world.legs[0], world.time).position);
    }
}

TEST_CASE("a ball that touches at the start is on its surface from the first leg on, and rests without a landing") {
    History history;
    World const world = world_at_start(Steps{}, floor_with({0, 0.5 + 5e-10}, {0, 0}), history);
    CHECK(world.legs[0].phase != Phase::flight);
    CHECK(world.legs[0].contact == Contact{0, 1});
    REQUIRE(history.events.size() == 1);
    CHECK(history.events[0].kind == EventKind::rest);
}

TEST_CASE("a dropped ball without restitution lands once, then rests") {
    Scene const scene = floor_with({0, 1.5}, {0, 0});
    History history;
    World world = world_at_start(Steps{}, scene, history);
    advance(Steps{}, scene, world, 1, history);
    REQUIRE(history.events.size() == 2);
    CHECK(history.events[0].kind == EventKind::land);
    CHECK(history.events[0].time == doctest::Approx(std::sqrt(2 / 9.81)).epsilon(1e-12));
    CHECK(history.events[1].kind == EventKind::rest);
}

TEST_CASE("a ball left standing moves again when it is pulled") {
    Scene const scene = floor_with({0, 0.5}, {0, 0});
    History history;
    World world = world_at_start(Steps{}, scene, history);
    advance(Steps{}, scene, world, 2, history);
    Forces forces;
    forces.pull = Pull{0, {1, 0.5}};
    apply(Steps{}, scene, world, forces, history);
    advance(Steps{}, scene, world, 4, history);
    CHECK(at(world.legs[0], world.time).position.x() == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("a column is pressed together by the weight above over m_eff (2 pi f)^2") {
    struct Case {
        Steps method;
        double frequency;  // Hz: an eighth of 960 substeps a second, a quarter of 240
    };
    for (Case const& c : {Case{{240, 4}, 120}, Case{{60, 4}, 60}}) {
        Scene scene = floor_with({0, 0.5}, {0, 0});
        for (int i = 1; i < 10; ++i) {
            scene.balls.push_back(scene.balls[0]);
            scene.balls.back().start.position.y() += i;
        }
        History history;
        World world = world_at_start(c.method, scene, history);
        advance(c.method, scene, world, 4, history);
        double const omega = 2 * pi * c.frequency;
        auto const height = [&](int ball) { return at(world.legs[ball], world.time).position.y(); };
        // Balls that fall asleep at 1e-4 m/s may lack 3e-6 m: overlaps are pushed out at some 36 /s.
        for (int i = 1; i < 10; ++i)
            CHECK(1 - (height(i) - height(i - 1)) ==
                  doctest::Approx((10 - i) * 9.81 / (0.5 * omega * omega)).epsilon(0.01).scale(3e-4));
        CHECK(0.5 - height(0) == doctest::Approx(10 * 9.81 / (4 * omega * omega)).epsilon(0.01).scale(3e-4));
    }
}

TEST_CASE("balls asleep in a row wake one after the other when the first is pressed against them") {
    Scene scene = floor_with({0, 0.5}, {0, 0});
    for (int i = 1; i < 4; ++i) {
        scene.balls.push_back(scene.balls[0]);
        scene.balls.back().start.position.x() += i;
    }
    History history;
    World world = world_at_start(Steps{}, scene, history);
    advance(Steps{}, scene, world, 2, history);
    for (Leg const& leg : world.legs) REQUIRE(leg.phase == Phase::rest);
    Forces forces;
    forces.pull = Pull{0, {0.02, 0.5}};
    apply(Steps{}, scene, world, forces, history);
    advance(Steps{}, scene, world, 4, history);
    CHECK(at(world.legs[0], world.time).position.x() >= 0.019);
    CHECK(at(world.legs[3], world.time).position.x() >= 3.019);
}

TEST_CASE("a ball asleep on two others falls when one of them is pulled from under it") {
    Scene scene = floor_with({0, 0.5}, {0, 0});
    Material const rough{0.9, 0, 0.5};
    scene.terrain = terrain_of({{Segment{{-100, 0}, {100, 0}}, rough, 0}, {Segment{{-0.5, 0}, {-0.5, 5}}, {}, 0}});
    for (Vec2 const& place : {Vec2(1.2, 0.5), Vec2(0.6, 0.5 + 0.8)}) {
        scene.balls.push_back(scene.balls[0]);
        scene.balls.back().start.position = place;
    }
    scene.balls[1].friction = scene.balls[2].friction = 0.9;
    History history;
    World world = world_at_start(Steps{}, scene, history);
    advance(Steps{}, scene, world, 4, history);
    REQUIRE(at(world.legs[2], world.time).position.y() > 1);
    REQUIRE(world.legs[2].phase == Phase::rest);
    Forces forces;
    forces.pull = Pull{1, {9, 0.5}};
    apply(Steps{}, scene, world, forces, history);
    advance(Steps{}, scene, world, 6, history);
    CHECK(at(world.legs[2], world.time).position.y() == doctest::Approx(0.5).epsilon(1e-3));
}

TEST_CASE("the article's rule: what is kept is tangent, and the spin is -(v ^ n) / r whatever it was") {
    Scene scene = floor_with({0, 0.5}, {3, -2});
    scene.gravity = 0;
    State state = scene.balls[0].start;
    state.spin = 17;
    ArticleStep const step = article_step(scene, {}, 0, state, 1e-3);
    CHECK(step.state.velocity.x() == doctest::Approx(3).epsilon(1e-14));
    CHECK(std::abs(step.state.velocity.y()) <= 1e-14);
    CHECK(step.state.spin == doctest::Approx(-3 / 0.5));
    CHECK(step.state.angle == doctest::Approx(-3 * 1e-3 / 0.5));
}
