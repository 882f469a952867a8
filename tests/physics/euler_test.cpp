// The textbook's method: right to the first power of its step, and bounded where it cannot be right.
#include "physics/euler.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "physics/method.h"
#include "physics/world/overlap.h"

using namespace physics;
using geometry::Segment;

namespace {

constexpr double euler_g = 9.81;

Ball disc_at(Vec2 const& place, Vec2 const& velocity = Vec2::Zero()) {
    Ball ball;
    ball.start.position = place;
    ball.start.velocity = velocity;
    return ball;
}

Scene scene_of(std::vector<Piece> const& pieces, std::vector<Ball> const& balls) {
    Scene scene;
    scene.terrain = terrain_of(pieces);
    scene.balls = balls;
    return scene;
}

struct Run {
    Scene scene;
    Euler method;
    History history;
    World world;
    Run(Scene const& of, double rate) : scene(of), method{rate}, world(world_at_start(method, scene, history)) {}
    void to(double time) { advance(method, scene, world, time, history); }
    State now(int ball = 0) const { return at(world.legs[ball], world.time); }
    double overlap() const {
        std::vector<Vec2> centres;
        for (Leg const& leg : world.legs) centres.push_back(at(leg, world.time).position);
        return deepest_overlap(scene, centres);
    }
};

State state_after(Scene const& scene, double rate, double time) {
    Run run(scene, rate);
    run.to(time);
    return run.now();
}

// A slope through the origin that falls to the right by `angle`, with a disc on it.
Scene slope(double angle, double friction) {
    Vec2 const down(std::cos(angle), -std::sin(angle));
    return scene_of({{Segment{-100 * down, 100 * down}, {friction, 0, 0}, 0}}, {disc_at(0.5 * geometry::turned_left(down))});
}

}  // namespace

TEST_CASE("euler: a flight is euler_g h t / 2 ahead, half of it at twice the rate") {
    for (double const rate : {60.0, 120.0, 240.0, 480.0}) {
        State const state = state_after(scene_of({}, {disc_at({0, 0}, {1, 3})}), rate, 1);
        CHECK(state.position.x() == doctest::Approx(1).epsilon(1e-12));
        CHECK(state.position.y() == doctest::Approx(3 - euler_g / 2 - euler_g / (2 * rate)).epsilon(1e-12));
        CHECK(state.velocity.y() == doctest::Approx(3 - euler_g).epsilon(1e-12));
    }
}

TEST_CASE("euler: down a ramp the error falls with the step, rolling and sliding") {
    double const angle = 0.3, time = 2;
    for (double const friction : {0.9, 0.05}) {
        CAPTURE(friction);
        double const a = friction > 0.5 ? euler_g * std::sin(angle) / 1.5 : euler_g * (std::sin(angle) - friction * std::cos(angle));
        Vec2 const right = a * time * time / 2 * Vec2(std::cos(angle), -std::sin(angle)) +
                           0.5 * Vec2(std::sin(angle), std::cos(angle));
        double before = 0;
        for (double const rate : {60.0, 240.0, 960.0}) {
            State const state = state_after(slope(angle, friction), rate, time);
            double const error = geometry::length(state.position - right);
            CHECK(error <= 8 / rate);
            if (before > 0) CHECK(error == doctest::Approx(before / 4).epsilon(0.1));
            before = error;
            CHECK(geometry::length(state.velocity) == doctest::Approx(a * time).epsilon(0.02));
        }
    }
}

TEST_CASE("euler: a ball on the floor stands, and with infinite friction and nothing that presses it is a number") {
    Scene scene = scene_of({{Segment{{-9, 0}, {9, 0}}, {std::numeric_limits<double>::infinity(), 0.5, 0.1}, 0}},
                           {disc_at({0, 0.5})});
    Run run(scene, 240);
    run.to(2);
    CHECK(run.now().position == Vec2(0, 0.5));
    CHECK(run.world.legs[0].phase == Phase::rest);
    CHECK(run.world.legs[0].contact == Contact{0, 1});
    scene.gravity = 0;
    scene.balls[0].start.velocity = {1, 0};
    State const state = state_after(scene, 240, 1);
    CHECK(state.position.x() == doctest::Approx(1).epsilon(1e-12));
    CHECK(state.spin == 0);
}

TEST_CASE("euler: a bounce returns e^2 of the height, to the step") {
    Run run(scene_of({{Segment{{-9, 0}, {9, 0}}, {0, 0.8, 0}, 0}}, {disc_at({0, 2.5})}), 960);
    double highest = 0;
    while (run.world.time < 1.6) {
        run.to(run.world.time + 1 / 960.0);
        if (run.world.time > 0.7) highest = std::max(highest, run.now().position.y() - 0.5);
    }
    CHECK(highest == doctest::Approx(0.64 * 2).epsilon(0.02));
    CHECK(std::any_of(run.history.events.begin(), run.history.events.end(),
                      [](Event const& e) { return e.kind == EventKind::bounce; }));
}

TEST_CASE("euler: two balls that hit keep their momentum and part at e times their approach") {
    Ball a = disc_at({0, 0}, {3, 0}), b = disc_at({4, 0}, {-1, 0});
    a.friction = b.friction = 0;
    a.restitution = b.restitution = 0.7;
    b.mass = 2.5;
    Scene scene = scene_of({}, {a, b});
    scene.gravity = 0;
    Run run(scene, 240);
    run.to(2);
    CHECK(run.now(0).velocity.x() + 2.5 * run.now(1).velocity.x() == doctest::Approx(0.5).epsilon(1e-12));
    CHECK(run.now(1).velocity.x() - run.now(0).velocity.x() == doctest::Approx(0.7 * 4).epsilon(1e-12));
    CHECK(run.history.events.front().kind == EventKind::hit);
}

TEST_CASE("euler: at 240 Hz and modest speeds balls in a box overlap by little, and stay in it") {
    std::vector<Ball> balls;
    for (int i = 0; i < 12; ++i) balls.push_back(disc_at({1 + 1.1 * (i % 4) + 0.03 * (i / 4), 1 + 1.1 * (i / 4)}));
    Material const of{0.6, 0.3, 0};
    Run run(scene_of({{Segment{{0, 0}, {5, 0}}, of, 0}, {Segment{{0, 0}, {0, 9}}, of, 1}, {Segment{{5, 0}, {5, 9}}, of, 2}},
                     balls),
            240);
    double deepest = 0;
    for (int i = 1; i <= 600; ++i) {
        run.to(i / 60.0);
        deepest = std::max(deepest, run.overlap());
    }
    CHECK(deepest <= 0.05 * 0.5);
    CHECK(run.overlap() <= 0.02 * 0.5);
    for (int i = 0; i < 12; ++i) {
        CHECK(run.now(i).position.x() > 0.45);
        CHECK(run.now(i).position.x() < 4.55);
        CHECK(run.now(i).position.y() > 0.45);
    }
}

TEST_CASE("euler: what moves farther than its radius in a step passes through a line") {
    Scene const scene = scene_of({{Segment{{-9, 0}, {9, 0}}, {}, 0}}, {disc_at({0, 5}, {0, -200})});
    CHECK(state_after(scene, 60, 0.2).position.y() < 0);
    CHECK(state_after(scene, 2400, 0.2).position.y() >= 0.4);
}
