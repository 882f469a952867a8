// The textbook's method: right to the first power of its step, and bounded where it cannot be right.
#include "physics/euler.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "physics/world/overlap.h"
#include "scenes/scenes.h"

using namespace physics;
using namespace scenes;

namespace {

double overlap_in(Run const& run) {
    std::vector<Vec2> centres;
    for (Leg const& leg : run.world.legs) centres.push_back(at(leg, run.world.time).position);
    return deepest_overlap(run.scene, centres);
}

}  // namespace

TEST_CASE("euler: a flight is g h t / 2 ahead, half of it at twice the rate") {
    for (double const rate : {60.0, 120.0, 240.0, 480.0}) {
        State const state = state_after(Euler{rate}, scene_of({}, {disc_at({0, 0}, {1, 3})}), 1);
        CHECK(state.position.x() == doctest::Approx(1).epsilon(1e-12));
        CHECK(state.position.y() == doctest::Approx(3 - g / 2 - g / (2 * rate)).epsilon(1e-12));
        CHECK(state.velocity.y() == doctest::Approx(3 - g).epsilon(1e-12));
    }
}

TEST_CASE("euler: down a ramp the error falls with the step, rolling and sliding") {
    double const angle = 0.3, time = 2;
    for (double const friction : {0.9, 0.05}) {
        CAPTURE(friction);
        double const a =
            friction > 0.5 ? g * std::sin(angle) / 1.5 : g * (std::sin(angle) - friction * std::cos(angle));
        Slope const slope = slope_with(angle, disc_at({0, 0}), material(friction));
        Vec2 const right = a * time * time / 2 * slope.down + 0.5 * slope.normal;
        double before = 0;
        for (double const rate : {60.0, 240.0, 960.0}) {
            State const state = state_after(Euler{rate}, slope.scene, time);
            double const error = geometry::length(state.position - right);
            CHECK(error <= 8 / rate);
            if (before > 0) CHECK(error == doctest::Approx(before / 4).epsilon(0.1));
            before = error;
            CHECK(geometry::length(state.velocity) == doctest::Approx(a * time).epsilon(0.02));
        }
    }
}

TEST_CASE("euler: a ball on the floor stands, and with infinite friction and nothing that presses it is a number") {
    Scene scene = scene_of({line({-9, 0}, {9, 0}, {full_grip, 0.5, 0.1})}, {disc_at({0, 0.5})});
    Run run(Euler{240}, scene);
    run.to(2);
    CHECK(run.state().position == Vec2(0, 0.5));
    CHECK(run.world.legs[0].phase == Phase::rest);
    CHECK(run.world.legs[0].contact == Contact{0, 1});
    scene.gravity = 0;
    scene.balls[0].start.velocity = {1, 0};
    State const state = state_after(Euler{240}, scene, 1);
    CHECK(state.position.x() == doctest::Approx(1).epsilon(1e-12));
    CHECK(state.spin == 0);
}

TEST_CASE("euler: a bounce returns e^2 of the height, to the step") {
    Run run(Euler{960}, scene_of({line({-9, 0}, {9, 0}, {0, 0.8, 0})}, {disc_at({0, 2.5})}));
    double highest = 0;
    while (run.world.time < 1.6) {
        run.to(run.world.time + 1 / 960.0);
        if (run.world.time > 0.7) highest = std::max(highest, run.state().position.y() - 0.5);
    }
    CHECK(highest == doctest::Approx(0.64 * 2).epsilon(0.02));
    CHECK(run.count(EventKind::bounce) > 0);
}

TEST_CASE("euler: two balls that hit keep their momentum and part at e times their approach") {
    Ball a = disc_at({0, 0}, {3, 0}), b = disc_at({4, 0}, {-1, 0});
    a.friction = b.friction = 0;
    a.restitution = b.restitution = 0.7;
    b.mass = 2.5;
    Run run(Euler{240}, scene_of({}, {a, b}, 0));
    run.to(2);
    CHECK(run.state(0).velocity.x() + 2.5 * run.state(1).velocity.x() == doctest::Approx(0.5).epsilon(1e-12));
    CHECK(run.state(1).velocity.x() - run.state(0).velocity.x() == doctest::Approx(0.7 * 4).epsilon(1e-12));
    CHECK(run.history.events.front().kind == EventKind::hit);
}

TEST_CASE("euler: at 240 Hz and modest speeds balls in a box overlap by little, and stay in it") {
    std::vector<Ball> balls;
    for (int i = 0; i < 12; ++i) balls.push_back(disc_at({1 + 1.1 * (i % 4) + 0.03 * (i / 4), 1 + 1.1 * (i / 4)}));
    Run run(Euler{240}, scene_of(chain({{0, 9}, {0, 0}, {5, 0}, {5, 9}}, material(0.6, 0.3)), balls));
    double deepest = 0;
    for (int i = 1; i <= 600; ++i) {
        run.to(i / 60.0);
        deepest = std::max(deepest, overlap_in(run));
    }
    CHECK(deepest <= 0.05 * 0.5);
    CHECK(overlap_in(run) <= 0.02 * 0.5);
    for (int i = 0; i < 12; ++i) {
        CHECK(run.state(i).position.x() > 0.45);
        CHECK(run.state(i).position.x() < 4.55);
        CHECK(run.state(i).position.y() > 0.45);
    }
}

TEST_CASE("euler: what moves farther than its radius in a step passes through a line") {
    Scene const scene = scene_of({line({-9, 0}, {9, 0}, {})}, {disc_at({0, 5}, {0, -200})});
    CHECK(state_after(Euler{60}, scene, 0.2).position.y() < 0);
    CHECK(state_after(Euler{2400}, scene, 0.2).position.y() >= 0.4);
}
